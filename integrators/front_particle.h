#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "integrators/surface_builder.h"
#include "integrators/surface_particles.h"

namespace pellucid {

/// Where a particle's trajectory meets the mesh.
struct FrontPoint {
  static constexpr std::uint32_t no_vertex = std::numeric_limits<std::uint32_t>::max();

  double t = 0;
  FlowPoint flow;
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
};

/// Along a trajectory, the time of the vertex after the one at t so that they lie `move` apart.
/// Nothing when the particle ends at t. What is left at the end is shared out, so that no sliver
/// remains.
std::optional<double> next_vertex_time(Trajectory& path, double t, double move,
                                       FieldSampler& sampler);

/// How far two neighbours of the front are apart, world units.
struct Separation {
  double distance;
  double width;  // across the flow: a front edge may lean without its ribbon being wide
};
Separation separation(const FlowPoint& a, const FlowPoint& b);

/// Do the two move away from each other within 60° of the line that joins them? So they do on
/// either side of a separatrix.
bool are_parting(const FlowPoint& a, const FlowPoint& b);

}  // namespace pellucid
