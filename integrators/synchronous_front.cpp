// Front lines whose particles all advance by the same time: the simplest stream and path surfaces,
// as compared in Tian & Günther, Fig. 4 ("advancing front line with fixed topology",
// "with adaptive refinement"). In shear the front leans, and its triangles become needles: that is
// what Hultquist's ribbons avoid. A quadrilateral is cut along the diagonal whose triangles keep to
// the surface's normals; the shorter one would fold where the front leans.
#include "integrators/synchronous_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "integrators/front_line.h"
#include "integrators/surface_parameters.h"

namespace pellucid {
namespace {

class SynchronousFront {
 public:
  /// `rows`: so many of equal duration without refinement; 0: as the refinement says.
  SynchronousFront(SurfaceRun& run, const Refinement& refinement, int rows)
      : run_(run), refinement_(refinement), rows_(rows), front_(run, refinement, rows == 0) {}

  void sweep(std::span<const double> seeds, bool ring);

 private:
  struct Ribbon {
    int left, right;
  };

  std::vector<int> moving_particles() const;
  double next_row(std::span<const int> moving);
  void advance(std::span<const int> moving, double t);
  std::vector<Ribbon> ribbons() const;
  bool try_merge(const Ribbon& a, const Ribbon& b);
  void tile(const Ribbon& ribbon);
  void tile(const FrontPoint& left, const FrontPoint& right, std::span<const int> chain);
  bool diagonals_stray(const Ribbon& ribbon);
  double diagonal_sagitta(int left, int right, const Vec3& x) const;
  bool moves_on(int p) const { return !front_.at(p).path.end() || head_of(p).t < path_end(p); }
  const FrontPoint& head_of(int p) const { return front_.at(p).head; }
  double path_end(int p) const { return front_.at(p).path.time(); }

  SurfaceRun& run_;
  const Refinement& refinement_;
  int rows_;
  FrontLine front_;
  double t_ = 0;
  std::vector<FrontPoint> before_;  // by particle: its head in the row before
  std::vector<int> chain_;          // scratch of tile()
};

void SynchronousFront::sweep(std::span<const double> seeds, bool ring) {
  front_.start(seeds, ring);
  for (auto moving = moving_particles(); !moving.empty() && !run_.is_full();
       moving = moving_particles()) {
    const auto row = ribbons();
    t_ = next_row(moving);
    advance(moving, t_);
    for (std::size_t i = 0; i < row.size(); ++i)
      if (i + 1 < row.size() && try_merge(row[i], row[i + 1]))
        ++i;
      else
        tile(row[i]);
  }
  run_.retire(front_.particles());
}

std::vector<int> SynchronousFront::moving_particles() const {
  std::vector<int> moving;
  for (int p = 0; p < front_.size(); ++p)
    if (front_.at(p).is_linked() && moves_on(p)) moving.push_back(p);
  return moving;
}

std::vector<SynchronousFront::Ribbon> SynchronousFront::ribbons() const {
  std::vector<Ribbon> row;
  std::vector<bool> seen(std::size_t(front_.size()));
  const auto follow = [&](int first) {
    for (int p = first; p >= 0 && !seen[std::size_t(p)]; p = front_.at(p).right) {
      seen[std::size_t(p)] = true;
      if (front_.at(p).right >= 0) row.push_back({p, front_.at(p).right});
    }
  };
  for (int p = 0; p < front_.size(); ++p)
    if (front_.at(p).left < 0) follow(p);
  for (int p = 0; p < front_.size(); ++p) follow(p);  // rings
  return row;
}

double SynchronousFront::next_row(std::span<const int> moving) {
  const double duration = run_.options().trajectory.duration;
  if (rows_ > 0)
    return std::min(duration, duration * (std::round(t_ / duration * rows_) + 1) / rows_);
  std::vector<double> steps(moving.size());
  parallel_for(std::size_t(0), moving.size(), [&](std::size_t i) {
    FrontParticle& particle = front_.at(moving[i]);
    const auto head = [&](int q) { return q < 0 ? nullptr : &head_of(q); };
    steps[i] = allowed_step(refinement_, particle.path, particle.head, head(particle.left),
                            head(particle.right), run_.sampler());
  });
  const double dt = *std::min_element(steps.begin(), steps.end());
  const double left_over = duration - t_;
  if (left_over <= dt) return duration;
  return left_over < 1.5 * dt ? t_ + 0.5 * left_over : t_ + dt;
}

void SynchronousFront::advance(std::span<const int> moving, double t) {
  parallel_for(std::size_t(0), moving.size(), [&](std::size_t i) {
    FrontParticle& particle = front_.at(moving[i]);
    particle.path.release(particle.head.t);
    particle.path.reach(t, run_.sampler());
    particle.next = front_point(particle.path, std::min(t, particle.path.time()));
  });
  before_.resize(std::size_t(front_.size()));
  for (int p = 0; p < front_.size(); ++p) before_[std::size_t(p)] = head_of(p);
  for (const int p : moving) {
    FrontParticle& particle = front_.at(p);
    if (particle.next->t > particle.head.t) particle.head = *particle.next;
    particle.next.reset();
  }
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
  if (!can_do_without(refinement_, l, r, head_of(middle).flow.x)) return false;
  if (!is_well_shaped(m, r, l)) return false;
  const Vec3 between = front_.at(middle).path.position_at(0.5 * (m.t + t_));
  if (refinement_.by_tolerance() &&
      diagonal_sagitta(left, right, between) > refinement_.largest_sagitta() / 4)
    return false;
  front_.take_out(middle);
  front_.join(left, right);
  const auto triangle = [&](const FrontPoint& x, const FrontPoint& y, const FrontPoint& z) {
    run_.add_triangle(x.vertex, y.vertex, z.vertex);
  };
  triangle(before_[std::size_t(left)], m, head_of(left));
  triangle(m, before_[std::size_t(right)], head_of(right));
  triangle(m, head_of(right), head_of(left));
  return true;
}

/// How far x, from the middle of a ribbon's last piece, is from the nearer one of its diagonals.
double SynchronousFront::diagonal_sagitta(int left, int right, const Vec3& x) const {
  const FrontPoint &l0 = before_[std::size_t(left)], &r0 = before_[std::size_t(right)];
  return std::min(distance_to_segment(x, l0.flow.x, head_of(right).flow.x),
                  distance_to_segment(x, r0.flow.x, head_of(left).flow.x));
}

/// By tolerance: does the surface leave both diagonals of the ribbon's last piece too far?
bool SynchronousFront::diagonals_stray(const Ribbon& ribbon) {
  if (!refinement_.by_tolerance()) return false;
  const auto before = [&](int p) { return before_[std::size_t(p)].t; };
  const auto x =
      front_.surface_between(ribbon.left, (before(ribbon.left) + before(ribbon.right) +
                                           head_of(ribbon.left).t + head_of(ribbon.right).t) /
                                              4);
  return x && diagonal_sagitta(ribbon.left, ribbon.right, *x) > refinement_.largest_sagitta();
}

void SynchronousFront::tile(const Ribbon& ribbon) {
  const FrontPoint &l0 = before_[std::size_t(ribbon.left)],
                   &r0 = before_[std::size_t(ribbon.right)];
  const auto edges = front_.join(ribbon.left, ribbon.right, diagonals_stray(ribbon));
  chain_.clear();
  for (const auto& edge : edges) {
    if (!chain_.empty() && chain_.back() != edge.left) break;
    if (chain_.empty()) chain_.push_back(edge.left);
    chain_.push_back(edge.right);
  }
  if (chain_.size() == edges.size() + 1) tile(l0, r0, chain_);
  // A chain with a gap is not tiled: the hole becomes one row longer.
  // Without refinement nothing can fill the gap between a particle that ended and one that goes on.
  if (rows_ > 0 && !(moves_on(ribbon.left) && moves_on(ribbon.right)))
    front_.at(ribbon.left).right = front_.at(ribbon.right).left = -1;
}

using Corners = std::array<const FrontPoint*, 3>;

/// Not so where a particle stands still: its vertex is in both rows.
bool has_three_vertices(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  return a.vertex != b.vertex && b.vertex != c.vertex && c.vertex != a.vertex;
}

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

constexpr ParameterSpec fixed_own[] = {
    {.name = "particles",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "500",
     .min = 2,
     .max = 1e6,
     .unit = "particles",
     .help = "evenly spaced on the seed curve"},
    {.name = "rows",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "200",
     .min = 1,
     .max = 1e6,
     .unit = "rows",
     .help = "of vertices, evenly spaced in time"},
};

constexpr ParameterSpec adaptive_own[] = {
    {.name = "particles",
     .kind = ParameterSpec::Kind::integer,
     .default_value = "500",
     .min = 2,
     .max = 1e6,
     .unit = "particles",
     .help = "evenly spaced on the seed curve; more follow where they are needed"},
    threshold_parameter(
        "a ribbon wider than this gets a particle; default 0.5, unless a tolerance is given"),
    tolerance_parameter,
    step_parameter,
};

IntegratedSurface run_fixed(const SurfaceRequest& request, const Parameters& parameters) {
  const SurfaceOptions options = surface_options(request, parameters);
  const Refinement none{.threshold = std::numeric_limits<double>::infinity()};
  return run_surface(request, options, parameters.integer("particles"),
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       SynchronousFront(run, none, parameters.integer("rows")).sweep(seeds, ring);
                     });
}

IntegratedSurface run_adaptive(const SurfaceRequest& request, const Parameters& parameters) {
  const SurfaceOptions options = surface_options(request, parameters);
  // The paper's threshold of 0.5 is for the front's particles; in time its rows lie closer.
  const Refinement refinement = refinement_of(parameters, 0.5, 5);
  return run_surface(request, options, parameters.integer("particles"),
                     [&](SurfaceRun& run, std::span<const double> seeds, bool ring) {
                       SynchronousFront(run, refinement, 0).sweep(seeds, ring);
                     });
}

constexpr auto fixed_parameters = with_surface_parameters(fixed_own);
constexpr auto adaptive_parameters = with_surface_parameters(adaptive_own);

constexpr IntegratorRow fixed_row = {
    .name = "fixed-front",
    .title = "Front line without refinement",
    .citation =
        "as compared in Tian & Günther, Progressive Rendering of Transparent Integral Surfaces, "
        "additional material, Fig. 4, left",
    .parameters = fixed_parameters,
    .promises = {},
    .run = run_fixed,
};

constexpr IntegratorRow adaptive_row = {
    .name = "adaptive-front",
    .title = "Front line with particles inserted and removed",
    .citation =
        "as compared in Tian & Günther, Progressive Rendering of Transparent Integral Surfaces, "
        "additional material, Fig. 4, middle left",
    .parameters = adaptive_parameters,
    .promises = {.refines = true, .coarsens = true, .bounds_error = true},
    .run = run_adaptive,
};

}  // namespace

const IntegratorRow& fixed_front_integrator() { return fixed_row; }
const IntegratorRow& adaptive_front_integrator() { return adaptive_row; }

}  // namespace pellucid
