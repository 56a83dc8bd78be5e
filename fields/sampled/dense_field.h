// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "fields/field.h"
#include "fields/sampled/axis.h"
#include "fields/sampled/shared_samples.h"

namespace pellucid::fields {

/// An Interpolation says how values between samples are made: see LinearInterpolation,
/// CubicInterpolation (c1) and ConstantInterpolation.
enum class Interpolation { linear, c1, constant };

/// A position beyond the last sample by less than this many cells counts as at it.
inline constexpr double edge_rounding = 1e-9;

/// A GridFrame maps world positions to grid coordinates, in which samples lie at whole numbers.
struct GridFrame {
  Mat3 grid_from_world;
  Vec3 origin;  // world, of grid coordinates (0, 0, 0)

  Vec3 to_grid(const Vec3& x) const { return grid_from_world * (x - origin); }
  Box3 world_box(const Box3& grid_box) const;
  double smallest_unit() const;  // the world's length of the shortest step between samples
};

/// A DenseGrid holds samples of a velocity at all crossings of three axes, or in all cells between
/// them (Interpolation::constant), in world units per unit of time. Sample is glm::vec3 where a
/// file holds floats, Vec3 where it holds doubles. A sample that is not finite makes its cells
/// `not_finite`.
template <class Sample>
struct DenseGrid {
  std::array<Axis, 3> axes;
  SharedSamples<Sample> samples;   // the first axis runs fastest
  std::optional<GridFrame> frame;  // none: the axes are the world's
};

/// Makes a steady field of the grid's samples. Throws InputError naming `description` when the grid
/// has too few positions for the interpolation: c1 needs 4 along each axis, the others 2.
template <class Sample>
std::unique_ptr<VectorField> make_dense_field(DenseGrid<Sample> grid, Interpolation interpolation,
                                              std::string description);

}  // namespace pellucid::fields
