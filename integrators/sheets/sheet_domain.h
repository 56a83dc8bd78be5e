// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/vec.h"
#include "integrators/paths/seed_curve.h"
#include "integrators/sheets/seed_surface.h"

namespace pellucid::integrators {

/// A Release says where a particle starts, world units, and how long it is on its way, time units;
/// or how both change.
struct Release {
  Vec3 seed{0};
  double age = 0;
};

/// A SheetDomain holds the parameters of a sheet, called places. Those of a streak surface are
/// (s, y, 0), s on the seed curve and y = 1 for the particle that was let go first, 0 for the last
/// one; those of a time surface are its seed surface's.
struct SheetDomain {
  std::vector<Vec3> places;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool closed = false;          // x has the period 1
  bool creased = false;         // each triangle is a smooth piece of its own
  bool is_square = false;       // x and y lie in [0, 1]
  std::vector<double> corners;  // x at which the sheet has a crease, ascending
  std::function<Release(const Vec3& place)> release_at;
  /// How both change per step of the place.
  std::function<Release(const Vec3& place, const Vec3& step)> change_at;
  /// The sheet's normal where a particle with this velocity is let go; 0 where there is none.
  std::function<Vec3(const Vec3& place, const Vec3& velocity)> normal_at;

  /// Returns the step from one place to another one, the shorter way around.
  Vec3 step_between(const Vec3& from, const Vec3& to) const;
  /// Returns the place at this part of the way between two.
  Vec3 between(const Vec3& from, const Vec3& to, double part) const;
  /// Returns the largest side of the box around all places.
  double size() const;
};

/// Returns the domain of a streak surface; `curve` and what it holds are copied.
SheetDomain streak_domain(const SeedCurve& curve, double duration);

/// Returns the domain of a time surface; `seed` is copied.
SheetDomain time_domain(const SeedSurface& seed, double duration);

}  // namespace pellucid::integrators
