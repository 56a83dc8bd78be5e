// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Object space of opacity optimization: the parts of lines and surfaces that have one opacity each
// (Baeza Rojo et al. 2019, sections 2.2.4 and 4.1). Points are elements as they are.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"

namespace pellucid::scene {

/// Rows hold rows of numbers: row i is values[offsets[i]] up to, and without,
/// values[offsets[i + 1]].
struct Rows {
  std::vector<std::uint64_t> offsets{0};
  std::vector<std::uint32_t> values;

  std::size_t count() const { return offsets.size() - 1; }
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    return {values.data() + offsets[i], values.data() + offsets[i + 1]};
  }
  void end_row() { offsets.push_back(values.size()); }
};

/// Elements are those of all lines of a scene, or of all its surfaces. Opaque objects have none,
/// but are counted. Each element has a primitive at least.
struct Elements {
  std::vector<std::uint32_t> of_primitive;  // of each segment of a line, or triangle; opaque: 0
  Rows neighbours;                          // of each element, without itself
  Rows of_vertex;                           // what a vertex's opacity is mixed from; may be nothing
  std::vector<float> weights;               // beside of_vertex.values; of a vertex their sum is 1

  std::size_t count() const { return neighbours.count(); }
  std::uint64_t bytes() const;
};

/// Cuts the lines, at their points, into about `segments` elements of equal length in all. A vertex
/// mixes the two elements of its line between whose middles it lies, by its distance along the
/// line.
Elements line_elements(const Scene& scene, std::size_t segments);

/// A SurfaceDistance says how far points of a surface are apart: along the edges of its triangles,
/// up to 1.4 times as far as they are on regular grids, or over its triangles by the heat method,
/// as the paper has it (see geometry::HeatDistances), which takes much longer.
enum class SurfaceDistance { edges, heat };

/// Cuts the surfaces into about `patches` elements: the Voronoi cells of triangles that are far
/// from each other (farthest-point sampling); of each piece of surface that hangs together one at
/// least. Throws InputError for a triangle without an area where heat has to flow through it.
///
/// A vertex mixes the elements within twice the largest distance of a vertex from its own one's
/// centre, by ((R - d) / (R d))^2 (Franke and Little's weights): continuous, and the element's own
/// at its centre. The paper leaves the weights to Guenther et al. 2014.
Elements surface_elements(const Scene& scene, std::size_t patches,
                          SurfaceDistance distance = SurfaceDistance::edges);

/// Smooths opacities by Laplacian smoothing: an iteration moves each element's opacity half of the
/// way to the mean of its neighbours'. s of them along a line are a binomial filter of variance
/// s / 2 elements.
void smooth(const Elements& elements, int iterations, std::vector<float>& opacities);

/// Returns every vertex's opacity: the mean of its elements' opacities by their weights; 1 where it
/// has none.
std::vector<float> vertex_opacities(const Elements& elements, const std::vector<float>& opacities);

}  // namespace pellucid::scene
