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
#include <array>
#include <deque>

#include "integrators/front_particle.h"
#include "integrators/surface_parameters.h"
#include "integrators/surface_run.h"

namespace pellucid {
namespace {

/// Front lengths, in world units.
struct RibbonLimits {
  double threshold;  // neighbours farther apart get a particle between them
  double step;       // between the vertices of one trajectory
};

class RibbonFront {
 public:
  RibbonFront(SurfaceRun& run, const RibbonLimits& limits) : run_(run), limits_(limits) {}

  void sweep(std::span<const double> seeds, bool ring);

 private:
  /// A place of the front: particle -1 when none gets there.
  struct Place {
    double s, t;
    int particle;
  };

  Place place(double s, double t);
  void span(const Place& a, const Place& b);
  bool asks_for_more(int left, int right) const;
  void look_ahead(int p);
  void settle();
  bool goes_first(int p, int q) const;
  bool may_advance(int p) const;
  void advance(int p);
  void tile(int p, int q, const FrontPoint& before, bool to_right);
  void merge(int p, int middle, bool to_right);
  void wake(int p);
  void drain();
  int stuck_particle() const;

  double seed_after(int left, int right) const;
  FrontParticle& at(int p) { return particles_[std::size_t(p)]; }
  const FrontParticle& at(int p) const { return particles_[std::size_t(p)]; }

  SurfaceRun& run_;
  RibbonLimits limits_;
  std::vector<FrontParticle> particles_;
  std::deque<int> awake_;                  // something changed around them
  std::vector<std::array<int, 2>> edges_;  // of the front, as span() made them
};

void RibbonFront::sweep(std::span<const double> seeds, bool ring) {
  std::vector<Place> places;
  for (const double s : seeds) places.push_back(place(s, 0));
  if (ring) places.push_back({places.front().s + 1, 0, places.front().particle});
  for (std::size_t i = 1; i < places.size(); ++i) span(places[i - 1], places[i]);
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

RibbonFront::Place RibbonFront::place(double s, double t) {
  std::optional<FrontParticle> particle = run_.spawn(s, t);
  if (!particle) return {s, t, -1};
  particles_.push_back(std::move(*particle));
  return {s, t, int(particles_.size()) - 1};
}

/// The seed of `right` as `left` sees it: on a ring the last ribbon runs on past s = 1.
double RibbonFront::seed_after(int left, int right) const {
  const double s = at(right).s;
  return s > at(left).s ? s : s + 1;
}

bool RibbonFront::asks_for_more(int left, int right) const {
  const FlowPoint &a = at(left).head.flow, &b = at(right).head.flow;
  const auto [distance, width] = separation(a, b);
  return width > limits_.threshold || distance > 2 * limits_.threshold || are_parting(a, b);
}

/// Joins two places of the front by edges, with as many particles between as it takes. Where only
/// one of the places is reached, the other end of the gap is searched for.
void RibbonFront::span(const Place& a, const Place& b) {
  if (a.particle < 0 && b.particle < 0) return;
  const bool both = a.particle >= 0 && b.particle >= 0;
  if (both && !asks_for_more(a.particle, b.particle)) {
    edges_.push_back({a.particle, b.particle});
    return;
  }
  if (b.s - a.s <= run_.options().rip) {
    if (both) run_.tear(a.s, b.s);
    return;
  }
  if (!run_.may_spawn()) return;
  const Place middle = place(0.5 * (a.s + b.s), 0.5 * (a.t + b.t));
  span(a, middle);
  span(middle, b);
}

/// Links the new edges and looks where their particles go next.
void RibbonFront::settle() {
  for (const auto& [left, right] : edges_) {
    at(left).right = right;
    at(right).left = left;
    for (const int p : {left, right}) {
      if (at(p).head.vertex == FrontPoint::no_vertex) at(p).head.vertex = run_.add_vertex(at(p));
      if (!at(p).next) look_ahead(p);
    }
  }
  for (const auto& [left, right] : edges_)
    for (const int p : {left, right}) wake(p);
  edges_.clear();
}

void RibbonFront::look_ahead(int p) {
  FrontParticle& particle = at(p);
  const auto t = next_vertex_time(particle.path, particle.head.t, limits_.step, run_.sampler());
  if (t) particle.next = FrontPoint{*t, particle.path.at(*t)};
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
  if (left >= 0) tile(p, left, before, false);
  if (right >= 0) tile(p, right, before, true);
  wake(p);
  wake(at(p).left);
  wake(at(p).right);
}

/// Tiles the ribbon between p, which came from `before`, and its neighbour q. The triangle's new
/// edge becomes several when it asks for particles on it.
void RibbonFront::tile(int p, int q, const FrontPoint& before, bool to_right) {
  const Place mine{at(p).s, at(p).head.t, p};
  if (to_right) {
    at(p).right = at(q).left = -1;
    span(mine, {seed_after(p, q), at(q).head.t, q});
  } else {
    at(p).left = at(q).right = -1;
    span({at(q).s, at(q).head.t, q}, {seed_after(q, p), mine.t, p});
  }
  const auto fan = edges_;
  settle();
  for (const auto& [a, b] : fan)
    run_.add_triangle(before.vertex, at(b).head.vertex, at(a).head.vertex);
  if (fan.size() == 1) merge(p, q, to_right);
}

/// Takes `middle` out between p and the particle behind it when these two have come close.
void RibbonFront::merge(int p, int middle, bool to_right) {
  const int far = to_right ? at(middle).right : at(middle).left;
  if (far < 0 || far == p || !at(middle).next) return;
  const int beyond = to_right ? at(far).right : at(far).left;
  if (beyond == p) return;  // a ring keeps three particles
  const auto [distance, width] = separation(at(p).head.flow, at(far).head.flow);
  if (width > 0.5 * limits_.threshold || distance > limits_.threshold) return;
  const int left = to_right ? p : far, right = to_right ? far : p;
  if (asks_for_more(left, right)) return;
  const std::uint32_t m = at(middle).head.vertex, f = at(far).head.vertex, n = at(p).head.vertex;
  if (to_right)
    run_.add_triangle(m, f, n);
  else
    run_.add_triangle(f, m, n);
  at(middle).merged = true;
  at(middle).next.reset();
  at(middle).left = at(middle).right = -1;
  at(left).right = right;
  at(right).left = left;
  wake(far);
}

constexpr ParameterSpec own_parameters[] = {
    {.name = "particles",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "2",
     .min = 2,
     .max = 1e6,
     .unit = "particles",
     .help = "evenly spaced on the seed curve; more follow where they are needed"},
    {.name = "threshold",
     .default_value = "0.05",
     .min = 0,
     .unit = "world units",
     .help = "neighbours farther apart get a particle between them"},
    {.name = "step",
     .min = 0,
     .unit = "world units",
     .help = "between a particle's vertices; default: the threshold"},
};

IntegratedSurface run_hultquist(const SurfaceRequest& request, const Parameters& parameters) {
  const SurfaceOptions options = surface_options(request, parameters);
  RibbonLimits limits{};
  limits.threshold = positive(parameters, "threshold", 0);
  limits.step = positive(parameters, "step", limits.threshold);
  return run_surface(request, options, parameters.integer("particles"),
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       RibbonFront(run, limits).sweep(seeds, ring);
                     });
}

constexpr auto parameters = with_surface_parameters(own_parameters);

constexpr IntegratorRow row = {
    .name = "hultquist",
    .title = "Recursive ribbons",
    .citation = "Hultquist 1992, Constructing Stream Surfaces in Steady 3D Vector Fields",
    .parameters = parameters,
    .promises = {.refines = true, .coarsens = true},
    .run = run_hultquist,
};

}  // namespace

const IntegratorRow& hultquist_integrator() { return row; }

}  // namespace pellucid
