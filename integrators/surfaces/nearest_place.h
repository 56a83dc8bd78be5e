// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <span>

#include "integrators/surfaces/surface_tangents.h"

namespace pellucid::integrators {

/// A Place is a point of a surface by the surface's two parameters.
struct Place {
  double s = 0, t = 0;
};

/// A Stretch is a range of a parameter.
struct Stretch {
  double begin = -std::numeric_limits<double>::infinity();
  double end = std::numeric_limits<double>::infinity();

  double inside(double s) const { return std::clamp(s, begin, end); }
};

/// Returns the stretch between neighbouring corners, ascending in [0, 1), that holds s, which may
/// lie beyond 0 and 1 on a closed curve; without corners such a one has no end.
Stretch stretch_around(std::span<const double> corners, bool closed, double s);

/// Returns the move from a place towards `off`, world units, as far as both parameters stay within
/// their ranges: on the surface's border, and on a crease, one of them is fixed, and the other one
/// alone is corrected.
Move move_within(const Tangents& tangents, const Place& from, const Stretch& s, const Stretch& t,
                 const Vec3& off);

/// A SmoothPiece is a piece of a surface on which nearest points are sought.
struct SmoothPiece {
  /// The surface's point with its derivatives w by s and v by t; where the surface ends before t,
  /// its last one: t is set back.
  std::function<FlowPoint(double s, double& t)> point_at;
  /// The move from a place towards `off` that stays on the piece.
  std::function<Move(const Tangents& tangents, const Place& from, const Vec3& off)> move;
  Move small;    // no settled place is farther from the nearest one, however short the way
  double noise;  // world units: two evaluations of one place differ by no more
};

/// A NearestPlace is a place of a surface, and whether its distance is the smallest around.
struct NearestPlace {
  Place place;
  FlowPoint here;
  double distance;  // world units
  bool settled;
};

/// A distance of more than this part of the way to the nearest known point of the surface may be
/// the smallest around alone: a facet's sagitta is mostly less.
constexpr double doubtful_distance = 0.05;
/// From so many known points, the nearest ones, it is then looked for again.
constexpr std::size_t most_starts = 12;

/// Returns the nearest of what is found from `starts`, too, one after the other until one is within
/// the piece's noise. `nearest` is kept unless another one is a tenth nearer: it is on the sheet
/// that x belongs to, where others may lie over each other.
NearestPlace nearest_of(const SmoothPiece& piece, NearestPlace nearest,
                        std::span<const Place> starts, const Vec3& x);

/// Returns where the distance of x is smallest around `place`, which is left for nearer ones by
/// Gauss-Newton, whose moves are halved until they come nearer: near a fold or a place of rest,
/// where v all but vanishes, they overshoot.
NearestPlace nearest_place(const SmoothPiece& piece, Place place, const Vec3& x);

}  // namespace pellucid::integrators
