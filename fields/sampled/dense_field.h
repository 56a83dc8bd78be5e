// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fields/field.h"
#include "fields/sampled/axis.h"

namespace pellucid::fields {

enum class Interpolation { linear, c1 };

/// In cells: how far beyond the last sample still is at it.
inline constexpr double edge_rounding = 1e-9;

/// Grid coordinates, where samples lie at whole numbers, of a world position.
struct GridFrame {
  Mat3 grid_from_world;
  Vec3 origin;

  Vec3 to_grid(const Vec3& x) const { return grid_from_world * (x - origin); }
  Box3 world_box(const Box3& grid_box) const;
  double smallest_unit() const;  // the world's length of the shortest step between samples
};

/// Samples of a velocity at all crossings of three axes. Sample is glm::vec3 where a file holds
/// floats, Vec3 where it holds doubles. A sample that is not finite makes its cells `not_finite`.
template <class Sample>
struct DenseGrid {
  std::array<Axis, 3> axes;
  std::vector<Sample> samples;     // the first axis runs fastest
  std::optional<GridFrame> frame;  // none: the axes are the world's
};

/// Throws InputError naming `description` when the grid has too few samples for the interpolation.
template <class Sample>
std::unique_ptr<VectorField> make_dense_field(DenseGrid<Sample> grid, Interpolation interpolation,
                                              std::string description);

}  // namespace pellucid::fields
