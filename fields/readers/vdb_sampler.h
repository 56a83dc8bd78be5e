// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Includes OpenVDB: for vdb_field.cpp alone.

#include <openvdb/openvdb.h>

#include <cmath>

#include "fields/field.h"
#include "fields/finite.h"
#include "fields/sampled/dense_field.h"

namespace pellucid::fields {

/// Trilinear between the 8 voxels around a point.
template <class Grid>
class VdbSampler final : public FieldSampler {
 public:
  VdbSampler(const Grid& grid, const GridFrame& frame)
      : accessor_(grid.getConstUnsafeAccessor()), frame_(frame) {}

  SampleStatus velocity(const Vec3& x, double, Vec3& v) override {
    if (!gather(x)) return SampleStatus::outside;
    v = mix(mix(line(0), line(1), s_.y), mix(line(2), line(3), s_.y), s_.z);
    return is_finite(v) ? SampleStatus::ok : SampleStatus::not_finite;
  }

  SampleStatus velocity_and_jacobian(const Vec3& x, double, Vec3& v, Mat3& jacobian) override {
    if (!gather(x)) return SampleStatus::outside;
    const Vec3 near = mix(line(0), line(1), s_.y), far = mix(line(2), line(3), s_.y);
    v = mix(near, far, s_.z);
    const Mat3 by_index(mix(mix(rise(0), rise(1), s_.y), mix(rise(2), rise(3), s_.y), s_.z),
                        mix(line(1) - line(0), line(3) - line(2), s_.z), far - near);
    jacobian = by_index * frame_.grid_from_world;
    return is_finite(v) && is_finite(jacobian) ? SampleStatus::ok : SampleStatus::not_finite;
  }

 private:
  static Vec3 mix(const Vec3& a, const Vec3& b, double s) { return a + s * (b - a); }
  // The four edges of the cell that run along x.
  Vec3 line(int k) const { return mix(corner_[2 * k], corner_[2 * k + 1], s_.x); }
  Vec3 rise(int k) const { return corner_[2 * k + 1] - corner_[2 * k]; }

  /// Fills the corners and the place in their cell. False where no cell of active voxels holds x.
  bool gather(const Vec3& x) {
    const Vec3 p = frame_.to_grid(x);
    const Vec3 low = glm::floor(p);
    constexpr double limit = 1e9;  // of an index; a NaN is beyond it, too
    if (!glm::all(glm::lessThan(glm::abs(low), Vec3(limit)))) return false;
    s_ = p - low;
    return read_corners(low) || gather_at_edge(p);
  }

  bool read_corners(const Vec3& low) {
    const openvdb::Coord first(int(low.x), int(low.y), int(low.z));
    for (int k = 0; k < 8; ++k) {
      typename Grid::ValueType value;
      if (!accessor_.probeValue(first.offsetBy(k & 1, (k & 2) >> 1, (k & 4) >> 2), value))
        return false;
      corner_[k] = Vec3(value[0], value[1], value[2]);
    }
    return true;
  }

  /// A point on a layer of voxels, up to the transform's rounding, also belongs to the cells below
  /// it; above it there may be none.
  bool gather_at_edge(const Vec3& p) {
    const Vec3 nearest = glm::round(p);
    for (int below = 0; below < 8; ++below) {
      Vec3 low = glm::floor(p);
      s_ = p - low;
      for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(p[axis] - nearest[axis]) > edge_rounding) continue;
        s_[axis] = below >> axis & 1;
        low[axis] = nearest[axis] - s_[axis];
      }
      if (read_corners(low)) return true;
    }
    return false;
  }

  // Not registered with the tree, which never changes: threads would wait for each other there.
  typename Grid::ConstUnsafeAccessor accessor_;
  GridFrame frame_;
  Vec3 corner_[8];
  Vec3 s_;
};

}  // namespace pellucid::fields
