// J. P. M. Hultquist, "Constructing Stream Surfaces in Steady 3D Vector Fields", Proc. IEEE
// Visualization 1992, 171-178: ribbons between neighbouring particles are tiled by the shorter
// diagonal; where particles part a new one goes between them, where they meet the middle one is
// taken out, and a ribbon that opens too far is torn.
//
// What differs, and why:
// - The paper advances ribbons by recursion. Here the particle that is behind both its neighbours
//   advances, which tiles every ribbon exactly as the greedy shorter diagonal does, keeps one front
//   line, and needs no stack.
// - The paper puts new particles on the chord between two others. Its error is the sagitta of the
//   seed polyline, and never gets smaller. Here they start on the seed curve.
// - A front across a separatrix would be refined without end. When seeds are closer than `rip`, and
//   the front still asks for a particle between them, the ribbon is torn. The surface is then
//   started again, without the ribbons between those seeds, so that no earlier triangle spans them.
#include "integrators/hultquist.h"

#include <algorithm>
#include <deque>

#include "integrators/refinement.h"
#include "integrators/surface_parameters.h"
#include "integrators/surface_run.h"

namespace pellucid {
namespace {

class RibbonFront {
 public:
  RibbonFront(SurfaceRun& run, const Refinement& refinement) : run_(run), refinement_(refinement) {}

  void sweep(std::span<const double> seeds, bool ring);

 private:
  /// A place of the front: particle -1 when none gets there.
  struct Place {
    double s, t;
    int particle;
  };

  /// A front edge as span() makes it.
  struct Edge {
    int left, right;
    std::unique_ptr<Trajectory> shadow;
  };
  using Shadow = std::unique_ptr<Trajectory>;

  Place place(double s, double t, Shadow path);
  void span(const Place& a, const Place& b, Shadow shadow);
  Shadow shadow_between(const Place& a, const Place& b, Shadow known);
  void look_ahead(int p);
  void settle();
  bool goes_first(int p, int q) const;
  bool may_advance(int p) const;
  void advance(int p);
  void tile(int left, int right, int advanced, const FrontPoint& before);
  void merge(int p, int middle);
  void take_out(int middle);
  void wake(int p);
  void drain();
  int stuck_particle() const;

  double seed_after(int left, int right) const;
  FrontParticle& at(int p) { return particles_[std::size_t(p)]; }
  const FrontParticle& at(int p) const { return particles_[std::size_t(p)]; }

  SurfaceRun& run_;
  Refinement refinement_;
  std::vector<FrontParticle> particles_;
  std::deque<int> awake_;    // something changed around them
  std::vector<Edge> edges_;  // of the front, as span() made them
};

void RibbonFront::sweep(std::span<const double> seeds, bool ring) {
  std::vector<Place> places;
  for (const double s : seeds) places.push_back(place(s, 0, {}));
  if (ring) places.push_back({places.front().s + 1, 0, places.front().particle});
  for (std::size_t i = 1; i < places.size(); ++i) span(places[i - 1], places[i], {});
  settle();
  drain();
  for (int p = stuck_particle(); p >= 0; p = stuck_particle()) {
    advance(p);
    drain();
  }
  run_.retire(particles_);
}

void RibbonFront::drain() {
  while (!awake_.empty() && !run_.is_full()) {
    const int p = awake_.front();
    awake_.pop_front();
    if (may_advance(p)) advance(p);
  }
}

/// On a ring all particles may wait for their neighbour in a circle: the earliest one then goes.
int RibbonFront::stuck_particle() const {
  int earliest = -1;
  if (!awake_.empty()) return earliest;  // the budget is used up
  for (int p = 0; p < int(particles_.size()); ++p) {
    const bool waits = at(p).next && (at(p).left >= 0 || at(p).right >= 0);
    if (waits && (earliest < 0 || at(p).head.t < at(earliest).head.t)) earliest = p;
  }
  return earliest;
}

/// A particle from the seed at s, by the path that is known or a new one.
RibbonFront::Place RibbonFront::place(double s, double t, Shadow path) {
  if (!path)
    if (std::optional<Trajectory> started = run_.spawn(s, t))
      path = std::make_unique<Trajectory>(std::move(*started));
  if (path && !path->reach(t, run_.sampler())) run_.retire_shadow(*path), path.reset();
  if (!path) return {s, t, -1};
  particles_.emplace_back(s, std::move(*path));
  particles_.back().head = front_point(particles_.back().path, t);
  return {s, t, int(particles_.size()) - 1};
}

/// The seed of `right` as `left` sees it: on a ring the last ribbon runs on past s = 1.
double RibbonFront::seed_after(int left, int right) const {
  const double s = at(right).s;
  return s > at(left).s ? s : s + 1;
}

/// By tolerance every ribbon has a shadow particle halfway between the seeds of its own two: the
/// measure of what the mesh leaves out, at a constant cost per vertex, and the ribbon's next
/// particle when it gets one.
RibbonFront::Shadow RibbonFront::shadow_between(const Place& a, const Place& b, Shadow known) {
  if (!refinement_.by_tolerance() || known || !run_.may_spawn()) return known;
  std::optional<Trajectory> path = run_.spawn(0.5 * (a.s + b.s), 0.5 * (a.t + b.t));
  return path ? std::make_unique<Trajectory>(std::move(*path)) : nullptr;
}

/// Joins two places of the front by edges, with as many particles between as it takes. Where only
/// one of the places is reached, the other end of the gap is searched for.
void RibbonFront::span(const Place& a, const Place& b, Shadow shadow) {
  if (a.particle < 0 && b.particle < 0) return;
  const double s = 0.5 * (a.s + b.s), t = 0.5 * (a.t + b.t);
  if (a.particle >= 0 && b.particle >= 0) {
    shadow = shadow_between(a, b, std::move(shadow));
    Vec3 middle(0);
    if (shadow) {
      shadow->reach(t, run_.sampler());
      middle = shadow->at(std::min(t, shadow->time())).x;
    }
    const bool unknown = refinement_.by_tolerance() && !shadow;
    if (!unknown &&
        !asks_for_more(refinement_, at(a.particle).head, at(b.particle).head, &middle)) {
      edges_.push_back({a.particle, b.particle, std::move(shadow)});
      return;
    }
    if (b.s - a.s <= run_.options().rip) return run_.tear(a.s, b.s);
  } else if (b.s - a.s <= run_.options().rip) {
    return;
  }
  if (!shadow && !run_.may_spawn()) return;
  const Place middle = place(s, t, std::move(shadow));
  span(a, middle, {});
  span(middle, b, {});
}

/// Links the new edges and looks where their particles go next.
void RibbonFront::settle() {
  for (auto& [left, right, shadow] : edges_) {
    at(left).right = right;
    at(right).left = left;
    at(left).shadow = std::move(shadow);
  }
  for (const auto& [left, right, shadow] : edges_)
    for (const int p : {left, right}) {
      if (at(p).head.vertex == FrontPoint::no_vertex) at(p).head.vertex = run_.add_vertex(at(p));
      if (!at(p).next) look_ahead(p);
      wake(p);
    }
}

void RibbonFront::look_ahead(int p) {
  FrontParticle& particle = at(p);
  const auto head_of = [&](int q) { return q < 0 ? nullptr : &at(q).head; };
  const auto t = next_vertex_time(refinement_, particle.path, particle.head, head_of(particle.left),
                                  head_of(particle.right), run_.sampler());
  if (t) particle.next = front_point(particle.path, *t);
}

void RibbonFront::wake(int p) {
  if (p >= 0 && at(p).next) awake_.push_back(p);
}

/// The shorter diagonal of the ribbon between p and q starts where p goes next.
bool RibbonFront::goes_first(int p, int q) const {
  if (q < 0 || !at(q).next) return true;
  const double mine = glm::distance(at(p).next->flow.x, at(q).head.flow.x);
  const double other = glm::distance(at(q).next->flow.x, at(p).head.flow.x);
  return mine < other || (mine == other && at(p).s < at(q).s);
}

bool RibbonFront::may_advance(int p) const {
  const FrontParticle& particle = at(p);
  return particle.next && (particle.left >= 0 || particle.right >= 0) &&
         goes_first(p, particle.left) && goes_first(p, particle.right);
}

void RibbonFront::advance(int p) {
  const FrontPoint before = at(p).head;
  const int left = at(p).left, right = at(p).right;
  at(p).head = *at(p).next;
  at(p).next.reset();
  at(p).path.release(at(p).head.t);
  at(p).head.vertex = run_.add_vertex(at(p));
  look_ahead(p);
  if (left >= 0) tile(left, p, p, before);
  if (right >= 0) tile(p, right, p, before);
  wake(p);
  wake(at(p).left);
  wake(at(p).right);
}

/// Tiles the ribbon between two neighbours, one of which just advanced from `before`. The
/// triangle's new edge becomes several when it asks for particles on it.
void RibbonFront::tile(int left, int right, int advanced, const FrontPoint& before) {
  Shadow shadow = std::move(at(left).shadow);
  if (shadow) shadow->release(0.5 * (at(left).head.t + at(right).head.t));
  at(left).right = at(right).left = -1;
  edges_.clear();
  span({at(left).s, at(left).head.t, left}, {seed_after(left, right), at(right).head.t, right},
       std::move(shadow));
  settle();
  for (const Edge& edge : edges_)
    run_.add_triangle(before.vertex, at(edge.right).head.vertex, at(edge.left).head.vertex);
  if (edges_.size() == 1) merge(advanced, advanced == left ? right : left);
}

/// Takes out one of the ribbon's particles, the one that did not advance, when its neighbours have
/// come so close that the front can do without it.
void RibbonFront::merge(int p, int middle) {
  const bool to_right = at(p).right == middle;
  const int far = to_right ? at(middle).right : at(middle).left;
  if (far < 0 || !at(middle).next) return;
  const int beyond = to_right ? at(far).right : at(far).left;
  if (far == p || beyond == p) return;  // a ring keeps three particles
  const int left = to_right ? p : far, right = to_right ? far : p;
  if (!can_do_without(refinement_, at(left).head, at(right).head, at(middle).head.flow.x)) return;
  // By tolerance the one taken out becomes the shadow: it has to come from halfway.
  const bool halfway =
      seed_after(left, middle) - at(left).s == seed_after(middle, right) - at(middle).s;
  if (refinement_.by_tolerance() && !halfway) return;
  const FrontPoint &m = at(middle).head, &f = at(far).head, &n = at(p).head;
  if (!(to_right ? is_well_shaped(m, f, n) : is_well_shaped(f, m, n))) return;
  if (to_right)
    run_.add_triangle(m.vertex, f.vertex, n.vertex);
  else
    run_.add_triangle(f.vertex, m.vertex, n.vertex);
  take_out(middle);
  at(left).right = right;
  at(right).left = left;
  wake(far);
}

/// Its trajectory goes on as the shadow of the ribbon that closes over it, where one is wanted.
void RibbonFront::take_out(int middle) {
  FrontParticle& particle = at(middle);
  particle.merged = true;
  particle.next.reset();
  particle.lent = refinement_.by_tolerance();
  if (particle.lent)
    at(particle.left).shadow = std::make_unique<Trajectory>(std::move(particle.path));
  particle.shadow.reset();
  particle.left = particle.right = -1;
}

constexpr ParameterSpec own_parameters[] = {
    {.name = "particles",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "2",
     .min = 2,
     .max = 1e6,
     .unit = "particles",
     .help = "evenly spaced on the seed curve; more follow where they are needed"},
    threshold_parameter,
    tolerance_parameter,
    step_parameter,
};

IntegratedSurface run_hultquist(const SurfaceRequest& request, const Parameters& parameters) {
  const SurfaceOptions options = surface_options(request, parameters);
  const Refinement refinement = refinement_of(parameters, 0.05, 1);
  return run_surface(request, options, parameters.integer("particles"),
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       RibbonFront(run, refinement).sweep(seeds, ring);
                     });
}

constexpr auto parameters = with_surface_parameters(own_parameters);

constexpr IntegratorRow row = {
    .name = "hultquist",
    .title = "Recursive ribbons",
    .citation = "Hultquist 1992, Constructing Stream Surfaces in Steady 3D Vector Fields",
    .parameters = parameters,
    .promises = {.refines = true, .coarsens = true, .bounds_error = true},
    .run = run_hultquist,
};

}  // namespace

const IntegratorRow& hultquist_integrator() { return row; }

}  // namespace pellucid
