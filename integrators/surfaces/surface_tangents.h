// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "integrators/paths/magnitude.h"
#include "integrators/paths/trajectory.h"

namespace pellucid::integrators {

/// A step in the parameters of a surface.
struct Move {
  double ds, dt;
};

/// Tangents are the unit vectors of ∂x/∂s and ∂x/∂t and their lengths: products of the vectors
/// themselves would leave a double's range where a flow is slow or fast enough.
class Tangents {
 public:
  explicit Tangents(const FlowPoint& here)
      : w_length_(magnitude(here.w)),
        v_length_(magnitude(here.v)),
        w_(direction_of(here.w)),
        v_(direction_of(here.v)),
        cosine_(glm::dot(w_, v_)) {}

  /// Returns true when neither vanishes, and they are not parallel.
  bool span_a_plane() const { return w_ != Vec3(0) && v_ != Vec3(0) && sine2() > 1e-12; }
  /// Returns the least squares solution of off ≈ w ds + v dt; where they span no plane that of one
  /// of them alone.
  Move move_towards(const Vec3& off) const {
    const double wo = glm::dot(w_, off), vo = glm::dot(v_, off);
    if (!span_a_plane()) return v_ != Vec3(0) ? Move{0, vo / v_length_} : along_s(off, 0);
    return {(wo - cosine_ * vo) / sine2() / w_length_, (vo - cosine_ * wo) / sine2() / v_length_};
  }
  /// Returns the same with one of the two given.
  ///@{
  Move along_s(const Vec3& off, double dt) const {
    const double ds = (glm::dot(w_, off) - cosine_ * dt * v_length_) / w_length_;
    return {w_length_ > 0 ? ds : 0, dt};
  }
  Move along_t(const Vec3& off, double ds) const {
    const double dt = (glm::dot(v_, off) - cosine_ * ds * w_length_) / v_length_;
    return {ds, v_length_ > 0 ? dt : 0};
  }
  ///@}
  /// Returns how far the move takes a point, world units.
  double way(const Move& move) const {
    return glm::length(move.ds * w_length_ * w_ + move.dt * v_length_ * v_);
  }

 private:
  double sine2() const { return 1 - cosine_ * cosine_; }

  double w_length_, v_length_;
  Vec3 w_, v_;
  double cosine_;
};

}  // namespace pellucid::integrators
