// SPDX-License-Identifier: GPL-3.0-or-later
// Explicit Runge-Kutta integration with PI step size control and dense output after Hairer,
// Nørsett, Wanner, "Solving Ordinary Differential Equations I", 2nd ed. 1993: II.4 (step size),
// IV.2 of volume II, Eq. 2.43c (PI controller), II.6 (dense output).
#include "integrators/paths/trajectory.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fields/finite.h"
#include "integrators/paths/linear_flow.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/segment_distance.h"

namespace pellucid::integrators {
namespace {

ParticleState joined(const Vec3& a, const Vec3& b) { return {a.x, a.y, a.z, b.x, b.y, b.z}; }

double largest(const Vec3& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }

template <class State>
void add(State& y, double factor, const State& k) {
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += factor * k[i];
}

EndReason reason_of(fields::SampleStatus status) {
  return status == fields::SampleStatus::outside ? EndReason::left_domain : EndReason::not_finite;
}

bool is_by_jacobian(Companion companion) {
  return companion == Companion::variation || companion == Companion::conormal;
}

bool is_ghost(Companion companion) {
  return companion == Companion::ghost_reset || companion == Companion::ghost_rescaled;
}

// Where a step that leaves the domain stops being halved, in tolerances: some steps' errors
// together are no less.
constexpr double edge_tolerances = 10;
// The same in durations, for who rests: no tolerance tells how far that is. A tolerance is 1e-9 of
// an extent unless it is given.
constexpr double edge_durations = edge_tolerances * 1e-9;

/// A with dw/dt = A w.
Mat3 companion_rate(Companion companion, const Mat3& jacobian) {
  return companion == Companion::conormal ? -glm::transpose(jacobian) : jacobian;
}

/// Of a step's stages, world units per time.
double fastest(const std::array<ParticleState, 7>& k) {
  double speed = 0;
  for (const auto& stage : k) speed = std::max(speed, magnitude(first(stage)));
  return speed;
}

/// Has a sampler look in a particle's last cell first, for as long as it lives.
class Following {
 public:
  Following(fields::FieldSampler& sampler, fields::LastCell& last) : sampler_(sampler) {
    sampler_.follow(&last);
  }
  ~Following() { sampler_.follow(nullptr); }
  Following(const Following&) = delete;
  Following& operator=(const Following&) = delete;

 private:
  fields::FieldSampler& sampler_;
};

}  // namespace

Trajectory::Trajectory(const TrajectoryOptions& options, const Vec3& seed, const Vec3& companion,
                       fields::FieldSampler& sampler)
    : options_(&options) {
  assert(options.stepper && options.duration > 0);
  Vec3 carried = companion;
  if (options.companion == Companion::none) carried = Vec3(0);
  if (is_ghost(options.companion))
    carried = seed + options.ghost_distance * direction_of(companion);
  y_ = joined(seed, carried);
  const fields::SampleStatus status = slope(0, y_, f_, sampler);
  if (status != fields::SampleStatus::ok) {
    end_ = status == fields::SampleStatus::outside ? EndReason::outside : EndReason::not_finite;
    return;
  }
  rest_.center = seed;
  exists_ = true;
  // A step of no length, so that at(0) is known.
  steps_.push_back({0, 0, {{y_, f_, {}, {}, {}}}});
  end_at_rest();
  if (!end_) h_ = first_step(sampler);
}

/// II.4, "starting step size", with the acceleration from one Euler step: over h the error of order
/// p + 1 is about |v| τ (h / τ)^(p + 1), τ the time in which the velocity turns.
double Trajectory::first_step(fields::FieldSampler& sampler) {
  if (!options_->stepper->adaptive) return largest_step();
  const double probe = std::min(largest_step(), 1e-3 * options_->duration);
  State y = y_, f;
  add(y, probe, f_);
  if (slope(probe, y, f, sampler) != fields::SampleStatus::ok) return probe;
  const double turn = magnitude(first(f) - first(f_)) / probe;
  if (turn <= 1e-9 * speed() / options_->duration) return largest_step();
  // From rest the velocity of the Euler step's end stands for what is not yet there.
  const double tau = std::max(speed(), magnitude(first(f))) / turn;
  if (speed() == 0) return std::min(tau, std::sqrt(options_->tolerance / turn));
  return tau * std::pow(options_->tolerance / (speed() * tau), 1. / options_->stepper->order);
}

double Trajectory::speed() const { return magnitude(first(f_)); }

double Trajectory::largest_step() const {
  const double move = std::max(options_->max_move / speed(), kinkless_step());
  return std::min({options_->max_step, options_->duration, move});
}

/// A particle that rests, or nearly so, may be moved farther than largest_step() foresaw.
bool Trajectory::jumps_cells(double h, double speed) const {
  return options_->changing && h * speed > 2 * options_->max_move && h > kinkless_step();
}

/// Samples and the smooth field that they stand for differ by at most the sampling error ε, so that
/// the kinks at all the cells' faces together move a step of length h by at most 2 ε h: when that
/// is within the tolerance, a step may be longer than a cell, as in samples of a linear field. But
/// not so near to the samples' end that the way might lead out and in again.
double Trajectory::kinkless_step() const {
  if (!options_->filled) return 0;
  const Vec3 x = first(y_);
  const Vec3 room = glm::min(x - options_->filled->min, options_->filled->max - x);
  const double nearest = std::max(0.0, std::min({room.x, room.y, room.z}));
  return std::min(options_->tolerance / (2 * options_->velocity_error), 0.5 * nearest / speed());
}

fields::SampleStatus Trajectory::slope(double t, const State& y, State& f,
                                       fields::FieldSampler& sampler) {
  if (!fields::is_finite(first(y))) return fields::SampleStatus::not_finite;
  const double time = options_->start_time + (options_->path ? t : 0);
  Vec3 v, w(0);
  if (is_by_jacobian(options_->companion)) {
    Mat3 jacobian;
    const auto status = sampler.velocity_and_jacobian(first(y), time, v, jacobian);
    if (status != fields::SampleStatus::ok) return status;
    w = companion_rate(options_->companion, jacobian) * second(y);
  } else if (const auto status = sampler.velocity(first(y), time, v);
             status != fields::SampleStatus::ok) {
    return status;
  }
  // Past the domain's edge the ghost keeps its distance.
  if (is_ghost(options_->companion) &&
      sampler.velocity(second(y), time, w) != fields::SampleStatus::ok)
    w = v;
  f = joined(v, w);
  return fields::SampleStatus::ok;
}

bool Trajectory::reach(double t, fields::FieldSampler& sampler) {
  if (t_ >= t || end_) return t_ >= t;
  const Following following(sampler, last_cell_);
  while (t_ < t && !end_) step(sampler);
  return t_ >= t;
}

bool Trajectory::skip_to(double t, fields::FieldSampler& sampler) {
  const Following following(sampler, last_cell_);
  while (t_ < t && !end_) {
    step(sampler);
    release(t_);
  }
  return t_ >= t;
}

void Trajectory::step(fields::FieldSampler& sampler) {
  const double left = options_->duration - t_;
  const double wanted = std::min(h_, largest_step());
  // The last two steps share what is left rather than leave a sliver to the last one.
  const double h = wanted >= left ? left : wanted > 0.5 * left ? 0.5 * left : wanted;
  std::array<State, 7> k{};
  State y1;
  const fields::SampleStatus status = try_step(h, k, y1, sampler);
  if (++step_count_ >= options_->max_steps) end_ = EndReason::steps;
  if (status != fields::SampleStatus::ok) return shrink_after(status, h);

  const double error = options_->stepper->adaptive ? error_of(h, k, y1) : 0;
  const double order = options_->stepper->order;
  // Below the tolerance's own length an error cannot matter: so discontinuities are stepped over.
  // The fastest stage counts: from rest the first one says nothing.
  const bool small = !(error > 1) || h * fastest(k) <= options_->tolerance;
  const bool jumps = jumps_cells(h, fastest(k)), accepted = small && !jumps;
  if (accepted || !options_->stepper->adaptive) accept(h, k, y1, sampler);
  if (!options_->stepper->adaptive) return;
  // PI control: Eq. 2.43c with β = 0.2 / p = 0.04 for p = 5, as DOPRI5 has it.
  const double beta = 0.2 / order;
  double factor = 0.92 * std::pow(std::max(error, 1e-10), 0.75 * beta - 1 / order);
  if (accepted) factor *= std::pow(last_error_, beta);
  factor = std::clamp(factor, 0.2, jumps ? 0.5 : accepted && !near_edge_ ? 5. : 1.);
  if (accepted) last_error_ = std::max(error, 1e-4), near_edge_ = false;
  h_ = std::max(h * factor, std::numeric_limits<double>::min());
}

fields::SampleStatus Trajectory::try_step(double h, std::array<State, 7>& k, State& y1,
                                          fields::FieldSampler& sampler) {
  const ButcherTableau& rk = *options_->stepper;
  k[0] = f_;
  for (int i = 1; i < rk.stages; ++i) {
    State y = y_;
    for (int j = 0; j < i; ++j)
      if (rk.a[i][j] != 0) add(y, h * rk.a[i][j], k[j]);
    const fields::SampleStatus status = slope(t_ + rk.c[i] * h, y, k[i], sampler);
    if (status != fields::SampleStatus::ok) return status;
  }
  y1 = y_;
  for (int i = 0; i < rk.stages; ++i)
    if (rk.b[i] != 0) add(y1, h * rk.b[i], k[i]);
  return slope(t_ + h, y1, k[rk.stages], sampler);
}

double Trajectory::step_tolerance(double h) const {
  return std::max(options_->tolerance, options_->error_floor * h);
}

/// What rounding leaves of a position far from the origin, here or at x.
double Trajectory::rounding_at(const Vec3& x) const {
  return 16 * std::numeric_limits<double>::epsilon() * std::max(largest(first(y_)), largest(x));
}

/// The estimated error in tolerances.
double Trajectory::error_of(double h, const std::array<State, 7>& k, const State& y1) const {
  const ButcherTableau& rk = *options_->stepper;
  State e{};
  for (int i = 0; i <= rk.stages; ++i)
    if (rk.error[i] != 0) add(e, h * rk.error[i], k[i]);
  const double position = magnitude(first(e)) / (step_tolerance(h) + rounding_at(first(y1)));
  if (!is_by_jacobian(options_->companion)) return position;
  return std::max(position, magnitude(second(e)) /
                                (companion_tolerance() * std::max(magnitude(second(y_)), 1e-300)));
}

/// Of w, in its own length: its direction needs far less than the position, 1e-6 is 1e-4 degrees.
/// In samples the Jacobian jumps at every cell's face, and steps would have to be as short as the
/// tolerance there. But over a cell of width h the Jacobian is itself off by some 4 ε / h, with the
/// sampling error ε, for a time h / |v|: of that turn, 4 ε / |v|, a hundredth is let pass.
double Trajectory::companion_tolerance() const {
  if (options_->velocity_error == 0) return 1e-6;
  return std::clamp(0.04 * options_->velocity_error / speed(), 1e-6, 1e-3);
}

/// The way out of the domain, or into samples that are not numbers, is halved down to the edge.
void Trajectory::shrink_after(fields::SampleStatus status, double h) {
  near_edge_ = true;
  h_ = 0.5 * h;
  const bool far = h_ * speed() > edge_tolerances * options_->tolerance ||
                   (options_->changing && h_ > edge_durations * options_->duration);
  if (far && t_ + h_ > t_) return;
  end_ = reason_of(status);
}

void Trajectory::accept(double h, const std::array<State, 7>& k, const State& y1,
                        fields::FieldSampler& sampler) {
  const ButcherTableau& rk = *options_->stepper;
  State r5{};
  for (int i = 0; i <= rk.stages; ++i)
    if (rk.dense[i] != 0) add(r5, h * rk.dense[i], k[i]);
  Step step{t_, h, {}};
  for (int i = 0; i < 6; ++i) {
    // x(θ) = r₁ + θ (r₂ + (1-θ) (r₃ + θ (r₄ + (1-θ) r₅))), multiplied out.
    const double r2 = y1[i] - y_[i], r3 = h * k[0][i] - r2, r4 = r2 - h * k[rk.stages][i] - r3;
    auto& c = step.way.coefficients;
    c[0][i] = y_[i];
    c[1][i] = r2 + r3;
    c[2][i] = r4 - r3 + r5[i];
    c[3][i] = -r4 - 2 * r5[i];
    c[4][i] = r5[i];
  }
  steps_.push_back(step);
  rest_.way += h * speed();
  t_ = h >= options_->duration - t_ ? options_->duration : t_ + h;
  y_ = y1;
  f_ = k[rk.stages];
  if (is_ghost(options_->companion)) restrain_ghost(sampler);
  if (t_ >= options_->duration) end_ = EndReason::duration;
  if (std::isfinite(options_->max_length)) cut_to_length();
  if (!end_) end_at_rest();
}

/// Ends within the last step, where the way has the length that is asked for.
void Trajectory::cut_to_length() {
  const Step& step = steps_.back();
  const double whole = step.way.arc_length(1);
  if (length_ + whole >= options_->max_length) {
    const double theta = step.way.theta_of_length(std::max(0.0, options_->max_length - length_));
    t_ = std::min(t_, step.begin + theta * step.length);
    end_ = EndReason::length;
  }
  length_ += whole;
}

/// In a field that does not change: it moves too slowly to be seen in the whole duration, or it has
/// come to a sink. There a stepper's errors keep it moving: steps grow until each is off by the
/// tolerance, and v, which is about the tolerance over the time in which it changes, never gets
/// smaller. So it stands when its velocities would have taken it a long way, 256 tolerances, and it
/// was never 8 of them from where it began, some steps' errors together: what moves on at however
/// low a speed, its way straight at that scale, is away after 8. An orbit so small cannot be told
/// from errors. (Between the steps' ends nothing is gone at all where the stability function is 1.)
void Trajectory::end_at_rest() {
  if (options_->changing) return;
  constexpr double near = 8, long_way = 256;  // tolerances
  const double error = step_tolerance(steps_.back().length) + rounding_at(first(y_));
  if (glm::distance(first(y_), rest_.center) > near * error) rest_ = {first(y_), 0};
  const bool lingers = options_->stepper->adaptive && rest_.way > long_way * error;
  if (lingers || speed() * options_->duration <= options_->still) end_ = EndReason::stagnated;
}

void Trajectory::restrain_ghost(fields::FieldSampler& sampler) {
  const Vec3 apart = second(y_) - first(y_);
  const double distance = glm::length(apart);
  const bool far = distance > options_->ghost_distance;
  if (distance == 0 || !(far || options_->companion == Companion::ghost_rescaled)) return;
  y_ = joined(first(y_), first(y_) + options_->ghost_distance / distance * apart);
  slope(t_, y_, f_, sampler);
}

const Trajectory::Step& Trajectory::step_at(double t) const {
  auto step = steps_.end() - 1;
  while (step != steps_.begin() && t < step->begin) --step;
  return *step;
}

FlowPoint Trajectory::at(double t) const {
  const Step& step = step_at(t);
  const double theta = step.theta(t);
  const State y = step.way.state(theta);
  const Vec3 w = is_ghost(options_->companion) ? second(y) - first(y) : second(y);
  // The seed's step has no length: its slope is dx/dt itself.
  return {first(y), step.way.derivative(theta) / (step.length > 0 ? step.length : 1), w};
}

FlowPoint Trajectory::at_rest(double t, fields::FieldSampler& sampler) const {
  FlowPoint point = at(t_);
  Vec3 v;
  Mat3 jacobian;
  const double time = options_->start_time + (options_->path ? t_ : 0);
  if (is_by_jacobian(options_->companion) &&
      sampler.velocity_and_jacobian(point.x, time, v, jacobian) == fields::SampleStatus::ok)
    point.w = carried_linearly(companion_rate(options_->companion, jacobian), t - t_, point.w);
  return point;
}

Vec3 Trajectory::position_at(double t) const {
  const Step& step = step_at(t);
  return step.way.position(step.theta(t));
}

double Trajectory::sagitta(double t0, double t1) const {
  const Vec3 from = position_at(t0), to = position_at(t1);
  const auto off = [&](double part) {
    return distance_to_segment(position_at(t0 + part * (t1 - t0)), from, to);
  };
  // Not quarters: a flow that swings has a period, and they might all be multiples of it.
  return options_->changing ? std::max({off(0.5), off(0.19), off(0.82)}) : off(0.5);
}

Vec3 Trajectory::acceleration(double t) const {
  const Step& step = step_at(t);
  if (step.length == 0) return Vec3(0);
  return step.way.second_derivative(step.theta(t)) / (step.length * step.length);
}

void Trajectory::release(double t) {
  auto keep = steps_.begin();
  while (keep + 1 != steps_.end() && keep->begin + keep->length < t) ++keep;
  steps_.erase(steps_.begin(), keep);
}

}  // namespace pellucid::integrators
