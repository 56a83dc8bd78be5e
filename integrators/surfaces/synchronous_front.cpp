// SPDX-License-Identifier: GPL-3.0-or-later
// Front lines whose particles all advance by the same time: the simplest stream and path surfaces,
// as compared in Tian & Günther, Fig. 4 ("advancing front line with fixed topology",
// "with adaptive refinement"). In shear the front leans, and its triangles become needles: that is
// what Hultquist's ribbons avoid. A quadrilateral is cut along the diagonal whose triangles keep to
// the surface's normals; the shorter one would fold where the front leans.
#include "integrators/surfaces/synchronous_front.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace pellucid::integrators {
namespace {

/// Not so where a particle stands still: its vertex is in both rows.
bool has_three_vertices(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  return a.vertex != b.vertex && b.vertex != c.vertex && c.vertex != a.vertex;
}

}  // namespace

void SynchronousFront::sweep(std::span<const double> seeds, bool ring) {
  front_.start(seeds, ring);
  for (line_up(); !moving_.empty() && !run_.is_full(); line_up()) {
    advance();
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (i + 1 < row_.size() && try_merge(row_[i], row_[i + 1]))
        ++i;
      else
        tile(row_[i]);
  }
  run_.retire(front_.particles());
}

/// Who is in the front line now: at no cost for those that have left it.
void SynchronousFront::line_up() {
  std::erase_if(line_, [&](int p) { return !front_.at(p).is_linked(); });
  for (; known_ < front_.size(); ++known_)
    if (front_.at(known_).is_linked()) line_.push_back(known_);
  moving_.clear();
  for (const int p : line_)
    if (moves_on(p)) moving_.push_back(p);
  row_.clear();
  ++row_count_;
  visited_.resize(std::size_t(front_.size()));
  for (const int p : line_)
    if (front_.at(p).left < 0) follow(p);
  for (const int p : line_) follow(p);  // rings
}

void SynchronousFront::follow(int first) {
  for (int p = first; p >= 0 && visited_[std::size_t(p)] != row_count_; p = front_.at(p).right) {
    visited_[std::size_t(p)] = row_count_;
    if (front_.at(p).right >= 0) row_.push_back({p, front_.at(p).right});
  }
}

/// Calls function(i, particle, neighbours' heads, sampler) for all that move, on all threads.
template <class Function>
void SynchronousFront::for_each_moving(const Function& function) {
  constexpr std::size_t grain = 64;  // a particle takes some 100 ns
  const tbb::blocked_range<std::size_t> all(0, moving_.size(), grain);
  parallel_ranges(all, [&](const tbb::blocked_range<std::size_t>& part) {
    fields::FieldSampler& sampler = run_.sampler();
    const auto head = [&](int p) { return p < 0 ? nullptr : &head_of(p); };
    for (std::size_t i = part.begin(); i < part.end(); ++i) {
      FrontParticle& particle = front_.at(moving_[i]);
      function(i, particle, head(particle.left), head(particle.right), sampler);
    }
  });
}

/// The next row: as far as the particle goes that may go least far.
void SynchronousFront::advance() {
  if (rows_ > 0) {
    const double duration = run_.options().trajectory.duration;
    t_ = std::min(duration, duration * (std::round(t_ / duration * rows_) + 1) / rows_);
    reach(t_);
  } else {
    advance_as_refined();
  }
  before_.resize(std::size_t(front_.size()));
  for (const int p : line_) before_[std::size_t(p)] = head_of(p);
  for (const int p : moving_) front_.at(p).go_on();
}

void SynchronousFront::advance_as_refined() {
  constexpr double growth = 1.5;  // so that few rows are tried in vain
  constexpr int most_attempts = 12;
  dt_ = std::min(planned_step(), growth * dt_);
  for (int attempt = 1;; ++attempt) {
    const double t = row_after(dt_), allowed = reach(t);
    if (allowed >= t - t_ || attempt == most_attempts) {
      t_ = t;
      return;
    }
    dt_ = allowed;
  }
}

/// By what is known before anybody moves.
double SynchronousFront::planned_step() {
  steps_.resize(moving_.size());
  for_each_moving([&](std::size_t i, FrontParticle& particle, const FrontPoint* left,
                      const FrontPoint* right, fields::FieldSampler&) {
    steps_[i] = integrators::planned_step(refinement_, particle.path, particle.head, left, right);
  });
  return *std::min_element(steps_.begin(), steps_.end());
}

double SynchronousFront::row_after(double dt) const {
  const double duration = run_.options().trajectory.duration, left_over = duration - t_;
  if (left_over <= dt) return duration;
  return left_over < 1.5 * dt ? t_ + 0.5 * left_over : t_ + dt;
}

/// Where everybody is at time t. Returns the longest step that all of them allow.
double SynchronousFront::reach(double t) {
  steps_.resize(moving_.size());
  for_each_moving([&](std::size_t i, FrontParticle& particle, const FrontPoint* left,
                      const FrontPoint* right, fields::FieldSampler& sampler) {
    // A row without refinement may be as long as it likes; what lies within it nobody asks for.
    if (rows_ > 0) {
      particle.path.skip_to(t, sampler);
    } else {
      particle.path.release(particle.head.t);
      particle.path.reach(t, sampler);
    }
    particle.next = front_point(particle.path, std::min(t, particle.path.time()));
    steps_[i] = rows_ > 0 ? std::numeric_limits<double>::infinity()
                          : allowed_step(refinement_, particle.path, particle.head, left, right,
                                         *particle.next);
  });
  return *std::min_element(steps_.begin(), steps_.end());
}

/// Takes out the particle between two ribbons, and tiles both.
bool SynchronousFront::try_merge(const Ribbon& a, const Ribbon& b) {
  const int left = a.left, middle = a.right, right = b.right;
  if (rows_ > 0 || middle != b.left || left == right || front_.at(right).right == left)
    return false;
  for (const int p : {left, middle, right})
    if (head_of(p).t != t_) return false;
  if (refinement_.by_tolerance() && !front_.is_halfway(middle)) return false;
  const FrontPoint &l = head_of(left), &m = before_[std::size_t(middle)], &r = head_of(right);
  const double sagitta = distance_to_segment(head_of(middle).flow.x, l.flow.x, r.flow.x);
  if (!can_do_without(refinement_, front_.abreast(left, right), sagitta)) return false;
  if (!front_.covers(left, middle, right)) return false;
  if (!is_well_shaped(m, r, l)) return false;
  const Trajectory& between = front_.at(middle).path;
  if (refinement_.by_tolerance() && diagonal_sagitta(left, right, [&](double t) {
                                      return between.position_at(t);
                                    }) > refinement_.largest_sagitta() / 4)
    return false;
  front_.take_out(middle);
  front_.join(left, right, {t_, t_});
  const auto triangle = [&](const FrontPoint& x, const FrontPoint& y, const FrontPoint& z) {
    run_.add_triangle(x.vertex, y.vertex, z.vertex);
  };
  triangle(before_[std::size_t(left)], m, head_of(left));
  triangle(m, before_[std::size_t(right)], head_of(right));
  triangle(m, head_of(right), head_of(left));
  return true;
}

/// How far the surface, known at any time halfway between the ribbon's seeds, is from the nearer
/// one of the two diagonals of the ribbon's last piece. Each is held against the surface at the
/// time of its own middle: where a neighbour has left the field within the row the two differ, and
/// between them the surface moves along itself.
template <class SurfaceAt>
double SynchronousFront::diagonal_sagitta(int left, int right, const SurfaceAt& surface_at) const {
  const auto sagitta = [&](const FrontPoint& a, const FrontPoint& b) {
    return distance_to_segment(surface_at(0.5 * (a.t + b.t)), a.flow.x, b.flow.x);
  };
  return std::min(sagitta(before_[std::size_t(left)], head_of(right)),
                  sagitta(before_[std::size_t(right)], head_of(left)));
}

/// By tolerance: does the surface leave both diagonals of the ribbon's last piece too far?
bool SynchronousFront::diagonals_stray(const Ribbon& ribbon) {
  const auto [left, right] = ribbon;
  Trajectory* shadow = front_.at(left).shadow.get();
  if (!refinement_.by_tolerance() || !shadow) return false;
  shadow->reach(std::max(head_of(left).t, head_of(right).t), run_.sampler());
  const double end = shadow->time();
  const auto surface_at = [&](double t) { return shadow->position_at(std::min(t, end)); };
  return diagonal_sagitta(left, right, surface_at) > refinement_.largest_sagitta();
}

void SynchronousFront::tile(const Ribbon& ribbon) {
  const FrontPoint &l0 = before_[std::size_t(ribbon.left)],
                   &r0 = before_[std::size_t(ribbon.right)];
  const auto edges = front_.join(ribbon.left, ribbon.right, {l0.t, r0.t}, diagonals_stray(ribbon));
  chain_.clear();
  for (const auto& edge : edges) {
    if (!chain_.empty() && chain_.back() != edge.left) break;
    if (chain_.empty()) chain_.push_back(edge.left);
    chain_.push_back(edge.right);
  }
  if (chain_.size() == edges.size() + 1) tile(l0, r0, chain_);
  // A chain with a gap is not tiled: the hole becomes one row longer.
  if (rows_ > 0 && !(moves_on(ribbon.left) && moves_on(ribbon.right))) end(ribbon);
}

/// Without refinement nothing can fill the gap between a particle that ended and one that goes on.
void SynchronousFront::end(const Ribbon& ribbon) {
  const auto [left, right] = ribbon;
  front_.at(left).right = front_.at(right).left = -1;
  if (!moves_on(right)) front_.at(left).left_alone = front_.at(right).path.end();
  if (!moves_on(left)) front_.at(right).left_alone = front_.at(left).path.end();
}

using Corners = std::array<const FrontPoint*, 3>;

/// Triangles between the edge of the row before and a chain of the new row: those left of some
/// corner of the chain share the edge's left end, those right of it the right one.
void SynchronousFront::tile(const FrontPoint& left, const FrontPoint& right,
                            std::span<const int> chain) {
  const std::size_t count = chain.size();  // of triangles: count - 1 on the chain, 1 on the edge
  const auto triangle = [&](std::size_t corner, std::size_t i) -> Corners {
    if (i + 1 == count) return {&left, &right, &head_of(chain[corner])};
    return {i < corner ? &left : &right, &head_of(chain[i + 1]), &head_of(chain[i])};
  };
  std::size_t best = 0;
  double best_shape = -std::numeric_limits<double>::infinity();
  for (std::size_t corner = 0; corner < count; ++corner) {
    double shape = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i)
      if (const auto [a, b, c] = triangle(corner, i); has_three_vertices(*a, *b, *c))
        shape = std::min(shape, well_shapedness(*a, *b, *c));
    if (shape > best_shape) best = corner, best_shape = shape;
  }
  for (std::size_t i = 0; i < count; ++i)
    if (const auto [a, b, c] = triangle(best, i); has_three_vertices(*a, *b, *c))
      run_.add_triangle(a->vertex, b->vertex, c->vertex);
}

}  // namespace pellucid::integrators
