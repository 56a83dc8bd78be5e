// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "integrators/front/refinement.h"
#include "integrators/front/surface_run.h"

namespace pellucid::integrators {

/// The line of particles that sweeps a surface, and how it is kept fine enough: what the
/// integrators that refine have in common.
class FrontLine {
 public:
  using Shadow = std::unique_ptr<Trajectory>;

  /// A place of the front: particle -1 when none gets there. What is tiled ends there at the time
  /// `tiled`: who ends between then and t belongs to the front all the same, at its end.
  struct Place {
    double s, t, tiled;
    int particle;
  };
  /// Times up to which what is tiled lies on either side of a ribbon.
  struct Tiled {
    double left, right;
  };
  /// An Edge joins two neighbours of the front.
  struct Edge {
    int left, right;
    Shadow shadow;        // by tolerance: from halfway between the seeds
    bool closes = false;  // the ribbon is tiled up to it, and ends there
  };

  /// `refines`: false keeps the particles as they start, and neighbours go as far as both do.
  FrontLine(SurfaceRun& run, const Refinement& refinement, bool refines = true)
      : run_(run), refinement_(refinement), refines_(refines) {}

  /// Starts particles from these seeds, and as many between as it takes, and links them.
  void start(std::span<const double> seeds, bool ring);
  /// Joins two neighbours by edges, with as many particles between as it takes, and links them.
  /// Fewer edges than it takes come back where the ribbon had to be torn. `split`: at least one
  /// particle more. The edges are known until the next call.
  std::span<const Edge> join(int left, int right, const Tiled& tiled, bool split = false);
  /// Takes a particle out: its neighbours become each other's.
  void take_out(int middle);
  /// Does it stand halfway between the seeds of its neighbours? By tolerance only such a particle
  /// can be taken out: it becomes the shadow of the ribbon that closes over it.
  bool is_halfway(int middle) const;
  /// Does the front miss nothing of the surface without the particle between two? It may not end
  /// before the edge between their heads nor, where both have come to the border, beyond it.
  bool covers(int left, int middle, int right);
  /// Two particles as they are compared: at their heads, but in an unsteady flow, whose velocities
  /// mean nothing beside those of another time, at the later one's time.
  Abreast abreast(int p, int q);

  FrontParticle& at(int p) { return particles_[std::size_t(p)]; }
  const FrontParticle& at(int p) const { return particles_[std::size_t(p)]; }
  int size() const { return int(particles_.size()); }
  std::vector<FrontParticle>& particles() { return particles_; }

 private:
  Place place(double s, double t, double tiled, Shadow path);
  Shadow shadow_between(const Place& a, const Place& b, Shadow known);
  std::optional<Vec3> halfway(int p, int q, Trajectory& between);
  bool is_fine(const Place& a, const Place& b, Trajectory* shadow);
  bool ends_early(int p) const;
  double border_sagitta(int p, int q, Trajectory& between);
  bool closes(const Place& a, const Place& b) const;
  void keep_coarse(const Place& a, const Place& b, Shadow shadow);
  double time_between(const Place& a, const Place& b) const;
  bool is_stretched(const Place& a, const Place& b) const;
  void span(const Place& a, const Place& b, Shadow shadow, bool split);
  void link_edges();
  double seed_after(int left, int right) const;

  SurfaceRun& run_;
  const Refinement& refinement_;
  bool refines_;
  std::vector<FrontParticle> particles_;
  std::vector<Edge> edges_;
};

}  // namespace pellucid::integrators
