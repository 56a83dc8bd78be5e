// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/front_line.h"

#include <algorithm>

namespace pellucid::integrators {
namespace {

/// Between seeds closer than this (in s) a front line is never refined: doubles end at 1e-16, and
/// trajectories are as exact as 1e-9 of the curve.
constexpr double closest_seeds = 1e-12;

}  // namespace

Abreast FrontLine::abreast(int p, int q) {
  const FrontPoint &a = at(p).head, &b = at(q).head;
  if (a.t == b.t || !run_.is_unsteady()) return {a, b};
  const double t = std::max(a.t, b.t);
  const auto comes_to = [&](int particle) {
    Trajectory& path = at(particle).path;
    return path.reach(t, run_.sampler()) || path.end() == EndReason::stagnated;
  };
  const bool both = comes_to(p) && comes_to(q);
  if (!both) return {a, b, false};
  const auto then = [&](int particle) {
    const Trajectory& path = at(particle).path;
    return front_point(path, std::min(t, path.time()));
  };
  return {then(p), then(q)};
}

void FrontLine::start(std::span<const double> seeds, bool ring) {
  std::vector<Place> places;
  for (const double s : seeds) places.push_back(place(s, 0, 0, {}));
  if (ring) places.push_back({places.front().s + 1, 0, 0, places.front().particle});
  edges_.clear();
  for (std::size_t i = 1; i < places.size(); ++i) span(places[i - 1], places[i], {}, false);
  link_edges();
}

std::span<const FrontLine::Edge> FrontLine::join(int left, int right, const Tiled& tiled,
                                                 bool split) {
  Shadow shadow = std::move(at(left).shadow);
  if (shadow) shadow->release(0.5 * (at(left).head.t + at(right).head.t));
  at(left).right = at(right).left = -1;
  edges_.clear();
  span({at(left).s, at(left).head.t, tiled.left, left},
       {seed_after(left, right), at(right).head.t, tiled.right, right}, std::move(shadow), split);
  link_edges();
  return edges_;
}

/// A particle from the seed at s, by the path that is known or a new one.
FrontLine::Place FrontLine::place(double s, double t, double tiled, Shadow path) {
  if (!path) path = run_.spawn(s, t, tiled);
  if (path && !path->reach(t, run_.sampler()) && !(path->time() > tiled)) {
    run_.drop(std::move(path), EndReason::torn);
    path = nullptr;
  }
  if (!path) return {s, t, tiled, -1};
  t = std::min(t, path->time());
  particles_.emplace_back(s, std::move(*path));
  particles_.back().head = front_point(particles_.back().path, t);
  return {s, t, tiled, size() - 1};
}

/// The seed of `right` as `left` sees it: on a ring the last ribbon runs on past s = 1.
double FrontLine::seed_after(int left, int right) const {
  const double s = at(right).s;
  return s > at(left).s ? s : s + 1;
}

/// By tolerance every ribbon has a shadow particle halfway between the seeds of its own two: the
/// measure of what the mesh leaves out, at a constant cost per vertex, and the ribbon's next
/// particle when it gets one.
FrontLine::Shadow FrontLine::shadow_between(const Place& a, const Place& b, Shadow known) {
  if (!refinement_.by_tolerance() || known || !run_.may_spawn()) return known;
  return run_.spawn(0.5 * (a.s + b.s), 0.5 * (a.t + b.t), 0.5 * (a.tiled + b.tiled));
}

/// The surface between the two beside the edge between their heads, by the particle from halfway
/// between their seeds; nothing where that has ended before. Once both have come to the border the
/// edge stands for the border, and the point is where the surface ends between them: beside the
/// edge's middle it may lie on the very chord, as in a uniform flow, and yet go on to a corner of
/// the domain, or past an obstacle at which both have ended.
std::optional<Vec3> FrontLine::halfway(int p, int q, Trajectory& between) {
  const bool at_border = at(p).is_at_border() && at(q).is_at_border();
  const double t =
      at_border ? run_.options().trajectory.duration : 0.5 * (at(p).head.t + at(q).head.t);
  const bool gets_there = between.reach(t, run_.sampler());
  if (!gets_there && !at_border && is_border(*between.end())) return std::nullopt;
  return between.position_at(std::min(t, between.time()));
}

/// How far the border of the surface halfway between two is from the line between their ends, of
/// which one is not reached yet: that one's triangles will fan out from the other's end, which is
/// right where the border leans, and reaches over what the border leaves out where it jumps.
double FrontLine::border_sagitta(int p, int q, Trajectory& between) {
  const auto end_of = [&](Trajectory& path) {
    path.reach(run_.options().trajectory.duration, run_.sampler());
    return path.position_at(path.time());
  };
  return distance_to_segment(end_of(between), end_of(at(p).path), end_of(at(q).path));
}

bool FrontLine::is_fine(const Place& a, const Place& b, Trajectory* shadow) {
  double sagitta = 0;
  if (refinement_.by_tolerance()) {
    const auto middle = shadow ? halfway(a.particle, b.particle, *shadow) : std::nullopt;
    if (!middle) return false;
    sagitta = distance_to_segment(*middle, at(a.particle).head.flow.x, at(b.particle).head.flow.x);
    if (ends_early(a.particle) != ends_early(b.particle))
      sagitta = std::max(sagitta, border_sagitta(a.particle, b.particle, *shadow));
  }
  return !asks_for_more(refinement_, abreast(a.particle, b.particle), sagitta);
}

bool FrontLine::covers(int left, int middle, int right) {
  const bool at_border = at(left).is_at_border() && at(right).is_at_border();
  if (!at_border && !refinement_.by_tolerance()) return true;
  const auto between = halfway(left, right, at(middle).path);
  if (!between || !at_border) return between.has_value();
  const double largest =
      refinement_.by_tolerance() ? refinement_.largest_sagitta() : refinement_.threshold;
  return distance_to_segment(*between, at(left).head.flow.x, at(right).head.flow.x) <= largest;
}

/// Has the particle come to the surface's border before the time is over?
bool FrontLine::ends_early(int p) const {
  return at(p).is_at_border() && at(p).head.t < run_.options().trajectory.duration;
}

/// Of two neighbours whose ways end apart, one at an obstacle that the other one passes, the ribbon
/// ends in an edge along the flow once it is so narrow that nobody misses what lies between, or as
/// `rip` was where it began: ribbons as thin as a small tolerance would take as short steps.
bool FrontLine::closes(const Place& a, const Place& b) const {
  const double width = separation(at(a.particle).head, at(b.particle).head).width;
  const double narrowest = run_.options().rip * run_.options().extent;
  return width <= std::max(shortest_edge(refinement_), narrowest) || b.s - a.s <= closest_seeds;
}

/// No particle is left for a ribbon that asks for one: it stays as it is, and its ends say so.
void FrontLine::keep_coarse(const Place& a, const Place& b, Shadow shadow) {
  if (a.particle < 0 || b.particle < 0) return run_.drop(std::move(shadow), EndReason::particles);
  at(a.particle).lacks_neighbour = at(b.particle).lacks_neighbour = true;
  edges_.push_back({a.particle, b.particle, std::move(shadow)});
}

/// Seeds that all but coincide have led to places that do not: the surface stretches, and a ribbon
/// is no better for its narrow seeds.
bool FrontLine::is_stretched(const Place& a, const Place& b) const {
  constexpr double stretched = 100;
  const SurfaceSetup& options = run_.options();
  return glm::distance(at(a.particle).head.flow.x, at(b.particle).head.flow.x) >
         stretched * options.rip * options.extent;
}

/// When the front has a particle between the two. One that stands still is where it is at any time,
/// also at the other one's.
double FrontLine::time_between(const Place& a, const Place& b) const {
  const auto stands = [&](int p) { return p >= 0 && at(p).path.end() == EndReason::stagnated; };
  if (!stands(a.particle) && !stands(b.particle)) return 0.5 * (a.t + b.t);
  return std::max(a.t, b.t);
}

/// Where only one of the places is reached, the other end of the gap is searched for.
void FrontLine::span(const Place& a, const Place& b, Shadow shadow, bool split) {
  if (a.particle < 0 && b.particle < 0) return;
  const bool both = a.particle >= 0 && b.particle >= 0;
  if (!refines_) {
    if (both) edges_.push_back({a.particle, b.particle, {}});
    return;
  }
  if (both) shadow = shadow_between(a, b, std::move(shadow));
  const bool narrow = b.s - a.s <= run_.options().rip;
  // Neighbours that part, or of which one is missing, lie on either side of an edge of the surface.
  const bool at_edge = !both || are_parting(abreast(a.particle, b.particle));
  const bool apart = both && (ends_early(a.particle) || ends_early(b.particle));
  const bool fine = both && (is_fine(a, b, shadow.get()) ||
                             (narrow && !at_edge && !apart && !is_stretched(a, b)));
  if (fine && (!split || narrow)) {
    edges_.push_back({a.particle, b.particle, std::move(shadow)});
    return;
  }
  if (apart && narrow && closes(a, b)) {
    run_.drop(std::move(shadow), EndReason::torn);
    edges_.push_back({a.particle, b.particle, {}, true});
    return;
  }
  // Where the flow changes, who parts at an instant does so for a while alone: there is no
  // separatrix, and the surface is whole however far it is stretched.
  const bool ends_here = at_edge && !(both && run_.is_unsteady());
  const bool torn = (narrow && ends_here) || b.s - a.s <= closest_seeds;
  if (both && torn) run_.tear(a.s, b.s);
  if (torn) return run_.drop(std::move(shadow), EndReason::torn);
  if (!shadow && !run_.may_spawn()) return keep_coarse(a, b, std::move(shadow));
  const Place middle =
      place(0.5 * (a.s + b.s), time_between(a, b), 0.5 * (a.tiled + b.tiled), std::move(shadow));
  span(a, middle, {}, false);
  span(middle, b, {}, false);
}

void FrontLine::link_edges() {
  for (auto& [left, right, shadow, closes] : edges_) {
    for (const int p : {left, right})
      if (at(p).head.vertex == FrontPoint::no_vertex) at(p).head.vertex = run_.add_vertex(at(p));
    if (closes) continue;
    at(left).right = right;
    at(right).left = left;
    at(left).shadow = std::move(shadow);
  }
}

bool FrontLine::is_halfway(int middle) const {
  const FrontParticle& particle = at(middle);
  const double left = at(particle.left).s, here = seed_after(particle.left, middle);
  return here - left == seed_after(middle, particle.right) - particle.s;
}

void FrontLine::take_out(int middle) {
  FrontParticle& particle = at(middle);
  FrontParticle& left = at(particle.left);
  run_.drop(std::move(left.shadow), EndReason::merged);
  run_.drop(std::move(particle.shadow), EndReason::merged);
  particle.merged = true;
  particle.next.reset();
  particle.lent = refinement_.by_tolerance();
  if (particle.lent) left.shadow = std::make_unique<Trajectory>(std::move(particle.path));
  left.right = particle.right;
  at(particle.right).left = particle.left;
  particle.left = particle.right = -1;
}

}  // namespace pellucid::integrators
