// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace pellucid::oit {

/// A MeshOpacity tells the opacity that an integrated surface has at a place (s, t) by the
/// opacities of its mesh's vertices: linear over each triangle, as the triangles are drawn. Beside
/// all triangles, where the mesh ends before the surface or has a hole, it is that of the nearest
/// place on one of them, in steps of the mesh.
///
/// Triangles are found by a grid over s and t, whose cells are of the size of a mean triangle.
class MeshOpacity {
 public:
  /// Takes the mesh of a surface, whose vertices have scalars s and t; with `closed` that of a
  /// closed seed curve, where s = 0 and s = 1 are one place.
  MeshOpacity(const geometry::TriangleMesh& mesh, bool closed);

  /// Returns the opacity, in [0, 1], at s in [0, 1] and t, of which the sign does not matter.
  float at(double s, double t) const;

  std::uint64_t bytes() const;

 private:
  /// A triangle in the plane of s and t.
  struct Facet {
    std::array<Vec2, 3> corners;
    std::array<float, 3> opacities;
  };
  struct Found {
    double distance;  // squared, in cells
    float opacity;
  };
  /// A facet's number beside the number of a cell that its box touches.
  using CellEntry = std::pair<std::uint32_t, std::uint32_t>;

  void add(const Facet& facet);
  void make_grid();
  void fill_grid();
  int column(double s) const;
  int row(double t) const;
  Found at_facet(const Facet& facet, const Vec2& place) const;
  void look_into(int column, int row, const Vec2& place, Found& best) const;

  std::vector<Facet> facets_;
  std::vector<CellEntry> entries_;  // by cell
  Vec2 cells_per_unit_{1};          // of s and of t
  int columns_ = 1, rows_ = 1;
};

}  // namespace pellucid::oit
