// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "oit/shapes/view_space.h"

namespace pellucid::oit {

/// A ClippedCorner is a corner of a part of a triangle.
struct ClippedCorner {
  Vec3 position;  // see ViewSpace::exact_position()
  Vec3 weights;   // of the triangle's corners
};

/// A GuardBand is where triangles may go on to outside of the picture and keep their digits when
/// their corners are rounded to float: up to 16 halves of the picture from its middle, and 16 times
/// the depth range before and behind it, but not behind the eye. A fragment of a triangle within it
/// is off by at most 16 · 6e-8 of half the picture (0.0005 pixels of 1000), and of d in the range.
/// Of a triangle that reaches beyond it the part within is drawn: in float, corners a billion times
/// farther away than the picture is wide put a fragment anywhere, and those beyond 1e38 nowhere.
class GuardBand {
 public:
  explicit GuardBand(const ViewSpace& view) : view_(view) {}

  /// Says whether a point lies within.
  bool holds(const Vec3& position) const;
  /// Says whether nothing of a disc is in the picture.
  bool disc_misses_picture(const Vec3& center, double radius) const;
  /// Says whether no point of a disc is farther from the picture's middle than 10000 of its halves:
  /// the rim of one that is would be off by a third of a pixel of 1000.
  bool holds_disc(const Vec3& center, double radius) const;
  /// Cuts a triangle off at the guard band; it overwrites `part`, a convex polygon, empty where
  /// nothing of the triangle is left or none of it is in the picture. Two triangles that share an
  /// edge share its cut ends, to the last bit.
  void clip(const std::array<Vec3, 3>& corners, std::vector<ClippedCorner>& part) const;

 private:
  static constexpr unsigned plane_count = 6;
  /// Returns how far within a plane of a band of `reach` halves of the picture the point lies.
  double height(unsigned plane, const Vec3& position, double reach) const;
  void clip(unsigned plane, double reach, std::vector<ClippedCorner>& part) const;
  /// Says whether the corners lie beyond one side of the picture, all of them.
  bool misses_picture(const std::array<Vec3, 3>& corners) const;

  ViewSpace view_;
};

}  // namespace pellucid::oit
