// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "integrators/paths/trajectory.h"

namespace pellucid::integrators {

/// A FrontPoint is where a particle's trajectory meets the mesh.
struct FrontPoint {
  static constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

  double t = 0;
  FlowPoint flow;
  double speed = 0;
  Vec3 direction{0};  // of the flow, unit; 0 where it stands still
  Vec3 normal{0};     // unit; 0 where the surface has none
  std::uint32_t vertex = no_vertex;
};

/// One particle of the front: the mesh reaches it at `head` and goes on to `next`.
struct FrontParticle {
  double s;
  Trajectory path;
  FrontPoint head;
  std::optional<FrontPoint> next;
  int left = -1, right = -1;  // neighbours; -1 where there is none, or where the ribbon was torn
  bool merged = false;
  bool lacks_neighbour = false;         // one was needed beside it, and none was to be had
  std::optional<EndReason> left_alone;  // why the last of its neighbours ended, and all ribbons
  bool lent = false;                    // merged, and its path is now its ribbon's shadow
  std::unique_ptr<Trajectory> shadow;   // from halfway to the right neighbour's seed

  bool is_linked() const { return left >= 0 || right >= 0; }
  /// Has the mesh reached the end of its way, and with it the surface's border?
  bool is_at_border() const {
    return path.end() && is_border(*path.end()) && head.t >= path.time();
  }
  /// Goes on to `next`, if it is later. Who rested meanwhile keeps its vertex: a second one there
  /// would make triangles without an area.
  void go_on();

  explicit FrontParticle(double seed, Trajectory trajectory)
      : s(seed), path(std::move(trajectory)) {}
};

/// The point of the trajectory at time t. Its normal is w × v, but 0 where these are parallel or
/// vanish: the surface has no normal there.
FrontPoint front_point(const Trajectory& path, double t);

/// A Separation tells how far two neighbours of the front are apart, in world units.
struct Separation {
  double distance;
  double width;  // across the flow: a front edge may lean without its ribbon being wide
};
/// Returns how far a and b are apart, in world units.
Separation separation(const FrontPoint& a, const FrontPoint& b);

/// Two neighbours of the front, as they are compared: in an unsteady flow both at the same time.
struct Abreast {
  FrontPoint a, b;
  bool comparable = true;  // false: one of them ended before the other one's time
};

/// Do the two move away from each other within 60° of the line that joins them? So they do on
/// either side of a separatrix.
bool are_parting(const FrontPoint& a, const FrontPoint& b);
/// The same of two that can be compared; two that cannot are told apart by their edge alone.
bool are_parting(const Abreast& two);

}  // namespace pellucid::integrators
