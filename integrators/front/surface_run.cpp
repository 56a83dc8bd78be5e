// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/surface_run.h"

#include <algorithm>

#include "core/machine/stopwatch.h"
#include "integrators/front/facet_mending.h"
#include "integrators/front/seed_features.h"
#include "integrators/paths/seed_place.h"

namespace pellucid::integrators {
namespace {

/// A stretch of the seed curve; it may run past s = 1 on a closed one.
struct Piece {
  double begin, end;
  bool ring;
};

/// What is left of the seed curve between the tears.
std::vector<Piece> pieces_between(std::vector<std::pair<double, double>> tears, bool closed,
                                  double rip) {
  if (tears.empty()) return {{0, 1, closed}};
  std::sort(tears.begin(), tears.end());
  std::vector<double> bounds;
  for (const auto& [left, right] : tears) bounds.insert(bounds.end(), {left, right});
  if (closed) {  // from the first tear once around to itself
    bounds.erase(bounds.begin());
    bounds.push_back(tears.front().first + 1);
  } else {
    bounds.insert(bounds.begin(), 0);
    bounds.push_back(1);
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < bounds.size(); i += 2)
    if (bounds[i + 1] - bounds[i] > 4 * rip) pieces.push_back({bounds[i], bounds[i + 1], false});
  return pieces;
}

/// Adds one between any two corners that have none between them: both ends of that ribbon would be
/// without a normal, and how it twists would not be seen.
void add_between_corners(const SeedCurve& curve, std::vector<double>& seeds) {
  std::vector<double> middles;
  for (std::size_t i = 1; i < seeds.size(); ++i)
    if (is_corner(curve, seeds[i - 1]) && is_corner(curve, seeds[i]))
      middles.push_back(0.5 * (seeds[i - 1] + seeds[i]));
  seeds.insert(seeds.end(), middles.begin(), middles.end());
  std::sort(seeds.begin(), seeds.end());
}

/// Where the first particles start: evenly over the whole curve, and at its corners.
std::vector<double> even_seeds(const SeedCurve& curve, int particles) {
  const int intervals = curve.closed ? particles : particles - 1;
  std::vector<double> seeds{1};
  for (int i = 0; i < intervals; ++i) seeds.push_back(double(i) / intervals);
  seeds.insert(seeds.end(), curve.corners.begin(), curve.corners.end());
  std::sort(seeds.begin(), seeds.end());
  return seeds;
}

/// Those of the piece, which may run past s = 1, and its ends.
std::vector<double> seeds_of(const Piece& piece, std::span<const double> first) {
  std::vector<double> seeds{piece.begin, piece.end};
  for (const double turn : {0., 1.})
    for (const double s : first) seeds.push_back(turn + s);
  std::sort(seeds.begin(), seeds.end());
  const auto begin = std::lower_bound(seeds.begin(), seeds.end(), piece.begin);
  const auto end = std::upper_bound(seeds.begin(), seeds.end(), piece.end);
  std::vector<double> inside(begin, end);
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  inside.erase(std::unique(inside.begin(), inside.end(), same), inside.end());
  if (piece.ring) inside.pop_back();
  return inside;
}

}  // namespace

SurfaceRun::SurfaceRun(const SurfaceRequest& request, const SurfaceSetup& options)
    : request_(request),
      options_(options),
      source_(request, options),
      builder_(request, options.trajectory.companion != Companion::none) {}

std::unique_ptr<Trajectory> SurfaceRun::spawn(double s, double t, double earliest) {
  auto path = std::make_unique<Trajectory>(source_.start(s));
  ++stats_.particles;
  if (!path->exists() || (!path->skip_to(t, sampler()) && !(path->time() > earliest))) {
    drop(std::move(path), EndReason::torn);
    return nullptr;
  }
  return path;
}

std::uint32_t SurfaceRun::add_vertex(const FrontParticle& particle) {
  return builder_.add_vertex(particle.head, particle.s);
}

void SurfaceRun::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (a == b || b == c || c == a) return;  // a particle rests
  builder_.add_triangle(a, b, c);
  if (builder_.triangle_count() % (1 << 14) == 0)
    report(request_.progress, builder_.newest_t() / request_.duration, "surface");
}

bool SurfaceRun::may_spawn() {
  if (stats_.particles < options_.max_particles) return true;
  budget_ = EndReason::particles;
  return false;
}

bool SurfaceRun::is_full() {
  if (builder_.triangle_count() < options_.max_triangles) return false;
  budget_ = EndReason::triangles;
  return true;
}

void SurfaceRun::retire(std::span<const FrontParticle> particles) {
  const EndReason otherwise = budget_.value_or(EndReason::torn);
  std::uint64_t bytes = builder_.bytes();
  for (const FrontParticle& particle : particles) {
    bytes += sizeof particle + particle.path.bytes();
    if (particle.shadow) bytes += sizeof(Trajectory) + particle.shadow->bytes();
    if (particle.shadow) ++stats_.ends[particle.shadow->end().value_or(otherwise)];
    if (particle.lent) continue;  // counted as a shadow
    if (particle.lacks_neighbour)
      ++stats_.ends[EndReason::particles];
    else if (particle.merged)
      ++stats_.ends[EndReason::merged];
    else if (particle.next)
      ++stats_.ends[otherwise];
    else
      ++stats_.ends[particle.path.end().value_or(particle.left_alone.value_or(otherwise))];
  }
  stats_.bytes = std::max(stats_.bytes, bytes);
}

void SurfaceRun::drop(std::unique_ptr<Trajectory> path, EndReason reason) {
  if (path) ++stats_.ends[path->end().value_or(reason)];
}

void SurfaceRun::mend() {
  if (budget_) return;  // it ended before it was whole
  const auto point_at = [&](double s, double t) -> std::optional<FrontPoint> {
    auto path = may_spawn() ? spawn(s, t, t) : nullptr;
    if (!path) return std::nullopt;
    const FrontPoint point = front_point(*path, t);
    ++stats_.ends[EndReason::vertex];
    return point;
  };
  stats_.trimmed = mend_facets(builder_,
                               {.largest_angle = options_.facet_angle,
                                .shortest_edge = options_.shortest_edge,
                                .most_vertices = 5000 + builder_.vertex_count() / 100,
                                .max_triangles = options_.max_triangles},
                               point_at);
}

IntegratedSurface SurfaceRun::finish() {
  stats_.evaluations = source_.evaluations();
  return {builder_.finish(), stats_};
}

void bound_facets(SurfaceSetup& setup, double facet_angle, const Refinement& refinement,
                  int particles) {
  setup.refines = true;
  setup.facet_angle = facet_angle;
  // A tolerance as large as the surface is wide, or as its ribbons, would have it trimmed away.
  const double narrow = 0.5 * setup.extent / std::max(particles, 16);
  setup.shortest_edge = std::min(shortest_edge(refinement), narrow);
}

IntegratedSurface run_surface(const SurfaceRequest& request, const SurfaceSetup& options,
                              int particles, const Sweep& sweep) {
  const Stopwatch watch;
  std::vector<std::pair<double, double>> tears;
  std::vector<double> first = even_seeds(request.seed, particles);
  if (options.refines) add_between_corners(request.seed, first);
  SeedFeatures features;
  if (options.refines) features = seed_features(request, options, first);
  first.insert(first.end(), features.seeds.begin(), features.seeds.end());
  const auto sweep_all = [&](bool again) {
    SurfaceRun run(request, options);
    for (const Piece& piece : pieces_between(tears, request.seed.closed, options.rip))
      sweep(run, seeds_of(piece, first), piece.ring);
    tears = run.tears();
    if (again || tears.empty()) run.mend();
    return run.finish();
  };
  IntegratedSurface surface = sweep_all(false);
  if (!tears.empty()) {
    const std::uint64_t evaluations = surface.stats.evaluations;
    surface = sweep_all(true);
    surface.stats.evaluations += evaluations;
  }
  surface.stats.evaluations += features.evaluations;
  surface.stats.seed_looks = options.refines ? seed_looks : 0;
  surface.stats.seconds = watch.seconds();
  return surface;
}

}  // namespace pellucid::integrators
