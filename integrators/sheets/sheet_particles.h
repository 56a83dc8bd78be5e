// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "integrators/paths/counting_sampler.h"
#include "integrators/paths/stepping_options.h"
#include "integrators/paths/trajectory.h"
#include "integrators/paths/trajectory_options.h"
#include "integrators/sheets/sheet_domain.h"
#include "integrators/sheets/sheet_integrator.h"

namespace pellucid::integrators {

/// A SheetParticle is a particle at the end of the journey: position, velocity, and the sheet's
/// normal there, of any length; 0 where there is none.
struct SheetParticle {
  Vec3 x{0}, v{0}, normal{0};
  double age = 0;                 // time units since it was let go
  std::optional<EndReason> lost;  // why it is not there at the end

  bool is_there() const { return !lost; }
};

/// A SheetSlope is a point of a sheet with its derivatives along two steps of the place.
struct SheetSlope {
  Vec3 x{0};
  std::array<Vec3, 2> along;
};

/// Sends particles of a sheet, on any number of threads at once.
class SheetParticles {
 public:
  /// `request` and `domain` must outlive it. `tolerance`, world units, is what the sheet may be off
  /// by: on samples the errors of particles add up to a thirtieth of it. Throws InputError.
  SheetParticles(const SheetRequest& request, const SheetDomain& domain,
                 const SteppingOptions& stepping, std::optional<double> tolerance);

  /// Sends particles from now on as the truth that a mesh is held to: see make_exact().
  void be_exact(double distance) { make_exact(options_, extent_, distance); }

  SheetParticle at(const Vec3& place);
  /// Nothing where the particle is not there at the end.
  std::optional<SheetSlope> slope_at(const Vec3& place, const std::array<Vec3, 2>& steps);

  double extent() const { return extent_; }  // world units, of the seeds
  const TrajectoryOptions& options() const { return options_; }
  std::uint64_t evaluations() const;
  /// Returns how many were sent until now.
  std::uint64_t sent() const { return sent_; }

 private:
  double end_time() const { return request_.start_time + request_.duration; }
  Vec3 velocity_at(const Release& release);
  std::optional<FlowPoint> send(const Release& release, const Vec3& companion, Companion kind,
                                std::optional<EndReason>& lost);

  const SheetRequest& request_;
  const SheetDomain& domain_;
  Box3 field_box_;
  double extent_;
  TrajectoryOptions options_;
  tbb::enumerable_thread_specific<CountingSampler> samplers_;
  std::atomic<std::uint64_t> sent_ = 0;
};

}  // namespace pellucid::integrators
