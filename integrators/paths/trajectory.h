// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/vec.h"
#include "fields/field.h"
#include "integrators/paths/butcher_tableau.h"
#include "integrators/paths/dense_output.h"
#include "integrators/paths/end_reason.h"

namespace pellucid::integrators {

/// A Companion travels with a particle to tell how the surface lies around it.
enum class Companion {
  none,
  variation,      // w = ∂x/∂s by the variational equation dw/dt = J(x) w
  conormal,       // w across a surface that goes with the flow: dw/dt = -Jᵀ(x) w
  ghost_reset,    // a second particle, pulled back when it is farther than `ghost_distance`
  ghost_rescaled  // a second particle, put back to `ghost_distance` after every step
};

/// TrajectoryOptions say how a particle is integrated.
struct TrajectoryOptions {
  const ButcherTableau* stepper = &dopri5();  // of steppers()
  double duration = 1;                        // time units
  double start_time = 0;                      // the field's time at the seed
  bool path = false;                          // the field's time runs along; else it stands still
  double tolerance = 1e-9;                    // world units: largest estimated error of one step
  double max_step = std::numeric_limits<double>::infinity();  // time units
  double max_move = std::numeric_limits<double>::infinity();  // world units in one step
  double velocity_error = 0;  // of the field, world units per time: what kinks of samples are worth
  double error_floor = 0;     // world units per time: errors below it are not worth a shorter step
  bool changing = false;      // the field changes on the way: who rests now may be moved later
  /// The box that samples fill: in it max_move does not hold for a step that is free of kinks.
  std::optional<Box3> filled;
  double still = 0;  // world units: moving less in the whole duration is standing
  double max_length = std::numeric_limits<double>::infinity();  // world units
  std::uint64_t max_steps = 1'000'000;
  Companion companion = Companion::none;
  double ghost_distance = 1e-5;  // world units
};

/// A point of a trajectory.
struct FlowPoint {
  Vec3 x{0};  // position
  Vec3 v{0};  // velocity
  Vec3 w{0};  // ∂x/∂s, or a normal, up to a positive factor; 0 without a companion
};

/// One particle's way, integrated as far as it is asked for and known everywhere between by dense
/// output. Not shared between threads while it is advanced.
class Trajectory {
 public:
  /// `options` must outlive it. `companion` is dc/ds of the seed curve, or a normal.
  Trajectory(const TrajectoryOptions& options, const Vec3& seed, const Vec3& companion,
             fields::FieldSampler& sampler);

  /// Integrates until t is covered. False when the particle ends before t.
  bool reach(double t, fields::FieldSampler& sampler);

  /// Integrates until t is covered, and forgets the way there.
  bool skip_to(double t, fields::FieldSampler& sampler);

  /// t between what was released and time().
  FlowPoint at(double t) const;
  /// The position alone.
  Vec3 position_at(double t) const;
  /// The point at t of a particle that came to rest before, in a field that does not change: it is
  /// where it came to rest, but its companion goes on turning, as dw/dt = J w tells where v is 0,
  /// too.
  FlowPoint at_rest(double t, fields::FieldSampler& sampler) const;
  /// Second time derivative of the position.
  Vec3 acceleration(double t) const;
  /// How long the velocity at one point tells at most how the particle goes on: the duration; where
  /// the field changes a tenth of it, since a particle may turn or set off meanwhile.
  double longest_plan() const {
    return options_->changing ? options_->duration / 10 : options_->duration;
  }
  /// Largest distance between its way from t0 to t1 and the chord, by the way's middle and, in a
  /// field that changes, two more of its places: there it may have gone there and back.
  double sagitta(double t0, double t1) const;
  /// Whether two places of it are the same but for what counts as standing.
  bool are_same(const Vec3& a, const Vec3& b) const {
    return glm::distance(a, b) <= options_->still;
  }
  /// How far two places of it are apart at least, world units.
  double still() const { return options_->still; }
  /// Forgets what lies before t.
  void release(double t);

  double time() const { return t_; }  // since the seed; up to where it is integrated
  /// Set when the particle goes no further than time().
  const std::optional<EndReason>& end() const { return end_; }
  /// False when not even the seed has a velocity.
  bool exists() const { return exists_; }
  std::uint64_t bytes() const { return steps_.capacity() * sizeof(Step); }  // beside itself

 private:
  using State = ParticleState;

  /// One step; θ = (t - begin) / length.
  struct Step {
    double begin, length;
    DenseOutput way;

    double theta(double t) const { return length > 0 ? std::min((t - begin) / length, 1.0) : 0; }
  };

  fields::SampleStatus slope(double t, const State& y, State& f, fields::FieldSampler& sampler);
  fields::SampleStatus try_step(double h, std::array<State, 7>& k, State& y1,
                                fields::FieldSampler& sampler);
  double error_of(double h, const std::array<State, 7>& k, const State& y1) const;
  void step(fields::FieldSampler& sampler);
  void accept(double h, const std::array<State, 7>& k, const State& y1,
              fields::FieldSampler& sampler);
  void restrain_ghost(fields::FieldSampler& sampler);
  double first_step(fields::FieldSampler& sampler);
  double step_tolerance(double h) const;
  double rounding_at(const Vec3& x) const;
  double companion_tolerance() const;
  bool jumps_cells(double h, double speed) const;
  double largest_step() const;
  double kinkless_step() const;
  double speed() const;
  void shrink_after(fields::SampleStatus status, double h);
  void cut_to_length();
  void end_at_rest();
  const Step& step_at(double t) const;

  const TrajectoryOptions* options_;
  double t_ = 0;
  double h_ = 0;           // the next step to try
  double last_error_ = 1;  // of the PI controller
  double length_ = 0;
  State y_{}, f_{};
  std::vector<Step> steps_;
  std::optional<EndReason> end_;
  bool exists_ = false;
  bool near_edge_ = false;  // a step failed: the domain's edge is close
  std::uint64_t step_count_ = 0;
  fields::LastCell last_cell_;

  /// A Rest is a stretch of the way on which the particle may be going nowhere.
  struct Rest {
    Vec3 center{0};
    double way = 0;  // world units: ∫ |v| dt since it was at `center`
  };
  Rest rest_;
};

}  // namespace pellucid::integrators
