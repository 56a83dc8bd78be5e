// SPDX-License-Identifier: GPL-3.0-or-later
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
//   A path surface of an unsteady flow has no separatrix, and is refined on.
#include "integrators/surfaces/hultquist.h"

#include <vector>

#include "integrators/front/front_line.h"
#include "integrators/front/refining_front.h"

namespace pellucid::integrators {
namespace {

class RibbonFront {
 public:
  RibbonFront(SurfaceRun& run, const Refinement& refinement)
      : run_(run), refinement_(refinement), front_(run, refinement) {}

  void sweep(std::span<const double> seeds, bool ring);

 private:
  void look_ahead(int p);
  bool goes_first(int p, int q) const;
  bool may_advance(int p) const;
  void advance(int p);
  void tile(int left, int right, int advanced, const FrontPoint& before);
  void merge(int p, int middle);
  void wake(int p);
  void drain();
  int stuck_particle() const;

  SurfaceRun& run_;
  const Refinement& refinement_;
  FrontLine front_;
  std::vector<int> awake_;  // something changed around them; a stack, so that work stays local
};

void RibbonFront::sweep(std::span<const double> seeds, bool ring) {
  front_.start(seeds, ring);
  for (int p = 0; p < front_.size(); ++p) look_ahead(p);
  for (int p = 0; p < front_.size(); ++p) wake(p);
  drain();
  for (int p = stuck_particle(); p >= 0; p = stuck_particle()) {
    advance(p);
    drain();
  }
  run_.retire(front_.particles());
}

void RibbonFront::drain() {
  while (!awake_.empty() && !run_.is_full()) {
    const int p = awake_.back();
    awake_.pop_back();
    if (may_advance(p)) advance(p);
  }
}

/// On a ring all particles may wait for their neighbour in a circle: the earliest one then goes.
int RibbonFront::stuck_particle() const {
  int earliest = -1;
  if (!awake_.empty()) return earliest;  // the budget is used up
  for (int p = 0; p < front_.size(); ++p) {
    const bool waits = front_.at(p).next && front_.at(p).is_linked();
    if (waits && (earliest < 0 || front_.at(p).head.t < front_.at(earliest).head.t)) earliest = p;
  }
  return earliest;
}

void RibbonFront::look_ahead(int p) {
  FrontParticle& particle = front_.at(p);
  if (particle.next || !particle.is_linked()) return;
  const auto head_of = [&](int q) { return q < 0 ? nullptr : &front_.at(q).head; };
  particle.next = next_vertex(refinement_, particle.path, particle.head, head_of(particle.left),
                              head_of(particle.right), run_.sampler());
}

void RibbonFront::wake(int p) {
  if (p >= 0 && front_.at(p).next) awake_.push_back(p);
}

/// Squared length of a diagonal, world units². In an unsteady flow particles may come back to where
/// they were: there the way between two times counts, at the speed of the faster one.
double diagonal2(const FrontPoint& a, const FrontPoint& b, bool unsteady) {
  const Vec3 apart = b.flow.x - a.flow.x;
  const double way = unsteady ? std::max(a.speed, b.speed) * (b.t - a.t) : 0;
  return glm::dot(apart, apart) + way * way;
}

/// The shorter diagonal of the ribbon between p and q starts where p goes next.
bool RibbonFront::goes_first(int p, int q) const {
  if (q < 0 || !front_.at(q).next) return true;
  const FrontParticle &a = front_.at(p), &b = front_.at(q);
  const double mine = diagonal2(*a.next, b.head, run_.is_unsteady());
  const double other = diagonal2(*b.next, a.head, run_.is_unsteady());
  return mine < other || (mine == other && a.s < b.s);
}

bool RibbonFront::may_advance(int p) const {
  const FrontParticle& particle = front_.at(p);
  return particle.next && particle.is_linked() && goes_first(p, particle.left) &&
         goes_first(p, particle.right);
}

void RibbonFront::advance(int p) {
  FrontParticle& particle = front_.at(p);
  const FrontPoint before = particle.head;
  const int left = particle.left, right = particle.right;
  particle.go_on();
  particle.path.release(particle.head.t);
  look_ahead(p);
  if (left >= 0) tile(left, p, p, before);
  if (right >= 0) tile(p, right, p, before);
  wake(p);
  wake(front_.at(p).left);
  wake(front_.at(p).right);
}

/// Of a chain of edges that is torn, the part that hangs together with the particle that advanced:
/// beyond the gap two triangles would meet in a single vertex.
std::span<const FrontLine::Edge> reached_from(int advanced,
                                              std::span<const FrontLine::Edge> edges) {
  std::size_t begin = 0, end = edges.size();
  for (std::size_t i = 1; i < edges.size(); ++i)
    if (edges[i].left != edges[i - 1].right) {
      if (edges[0].left == advanced) return edges.first(i);
      begin = i;
    }
  return edges.subspan(begin, end - begin);
}

/// Tiles the ribbon between two neighbours, one of which just advanced from `before`. The
/// triangle's new edge becomes several when it asks for particles on it.
void RibbonFront::tile(int left, int right, int advanced, const FrontPoint& before) {
  const auto tiled = [&](int p) { return p == advanced ? before.t : front_.at(p).head.t; };
  const auto edges = front_.join(left, right, {tiled(left), tiled(right)});
  for (const auto& edge : reached_from(advanced, edges))
    run_.add_triangle(before.vertex, front_.at(edge.right).head.vertex,
                      front_.at(edge.left).head.vertex);
  const bool whole = edges.size() == 1 && front_.at(left).right == right;
  if (whole) return merge(advanced, advanced == left ? right : left);
  for (const auto& edge : edges) {
    for (const int p : {edge.left, edge.right}) {
      look_ahead(p);
      wake(p);
    }
  }
}

/// Takes `middle` out when p, that just advanced, and the particle beyond have come so close that
/// the front can do without it.
void RibbonFront::merge(int p, int middle) {
  const bool to_right = front_.at(p).right == middle;
  const auto after = [&](int q) { return to_right ? front_.at(q).right : front_.at(q).left; };
  const int beyond = after(middle);
  if (beyond < 0 || !front_.at(middle).next) return;
  if (beyond == p || after(beyond) == p) return;  // a ring keeps three particles
  if (refinement_.by_tolerance() && !front_.is_halfway(middle)) return;
  const FrontPoint &m = front_.at(middle).head, &b = front_.at(beyond).head, &n = front_.at(p).head;
  const double sagitta = distance_to_segment(m.flow.x, n.flow.x, b.flow.x);
  if (!can_do_without(refinement_, front_.abreast(p, beyond), sagitta)) return;
  if (!(to_right ? front_.covers(p, middle, beyond) : front_.covers(beyond, middle, p))) return;
  const FrontPoint &first = to_right ? m : b, &second = to_right ? b : m;
  if (!is_well_shaped(first, second, n)) return;
  run_.add_triangle(first.vertex, second.vertex, n.vertex);
  front_.take_out(middle);
  wake(beyond);
}

constexpr double default_distance = 0.05;  // world units

using HultquistOptions = RefiningOptions<2>;

const OptionTable<HultquistOptions>& hultquist_options() {
  static const auto table = refining_options<HultquistOptions>(default_distance);
  return table;
}

IntegratedSurface run_hultquist(const SurfaceRequest& request, const Parameters& parameters) {
  return run_refining(
      request, hultquist_options().read(parameters), default_distance, 1,
      [](SurfaceRun& run, const Refinement& refinement, std::span<const double> seeds, bool ring) {
        RibbonFront(run, refinement).sweep(seeds, ring);
      });
}

}  // namespace

const IntegratorRow& hultquist_integrator() {
  static const IntegratorRow row = {
      .name = "hultquist",
      .title = "Recursive ribbons",
      .citation = "Hultquist 1992, Constructing Stream Surfaces in Steady 3D Vector Fields",
      .parameters = hultquist_options().specs(),
      .promises = {.refines = true, .coarsens = true, .bounds_error = true},
      .run = run_hultquist,
      .default_threshold = default_distance,
  };
  return row;
}

}  // namespace pellucid::integrators
