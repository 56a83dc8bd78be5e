// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/surfaces/surface_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.h"
#include "integrators/front/surface_particles.h"
#include "integrators/mesh/mesh_distance.h"
#include "integrators/mesh/mesh_samples.h"
#include "integrators/mesh/nearest_vertices.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/trajectory_options.h"
#include "integrators/surfaces/deviation.h"
#include "integrators/surfaces/nearest_place.h"

namespace pellucid::integrators {
namespace {

/// A point of the mesh with its parameters on the surface, and those of its facet's corners.
struct Sample {
  Place place;
  std::array<Place, 3> corners;
  Vec3 x, facet;  // facet: unit normal

  double middle() const { return (corners[0].s + corners[1].s + corners[2].s) / 3; }
};

Sample sample_of(const geometry::TriangleMesh& mesh, const MeshSample& place, bool closed) {
  const auto& corners = mesh.triangles[place.triangle];
  const auto &s = mesh.scalars.at("s"), &t = mesh.scalars.at("t");
  const double first = s[corners[0]];
  Sample sample{{}, {}, position_of(mesh, place), Vec3(0)};
  for (std::size_t k = 0; k < 3; ++k) {
    // Over the seam of a closed curve s jumps from 1 to 0.
    const double turn = closed ? std::round(first - s[corners[k]]) : 0;
    const Place corner{s[corners[k]] + turn, std::abs(t[corners[k]])};  // t < 0 on the way back
    sample.corners[k] = corner;
    sample.place.s += place.barycentric[k] * corner.s;
    sample.place.t += place.barycentric[k] * corner.t;
  }
  const Vec3& x = mesh.positions[corners[0]];
  sample.facet =
      direction_of(glm::cross(mesh.positions[corners[1]] - x, mesh.positions[corners[2]] - x));
  return sample;
}

/// The surface's unit normal; 0 where its tangents span no plane.
Vec3 normal_of(const FlowPoint& here) {
  if (!Tangents(here).span_a_plane()) return Vec3(0);
  return direction_of(glm::cross(direction_of(here.w), direction_of(here.v)));
}

/// The mesh's vertices, which are points of the surface, and whose (s, t) are known.
class KnownPlaces {
 public:
  explicit KnownPlaces(const geometry::TriangleMesh& mesh) : mesh_(mesh), tree_(mesh.positions) {}

  std::vector<std::uint32_t> around(const Vec3& x, std::size_t count) const {
    return tree_.around(x, count);
  }
  double distance(std::uint32_t vertex, const Vec3& x) const {
    return glm::distance(mesh_.positions[vertex], x);
  }
  Place place(std::uint32_t vertex) const {
    return {mesh_.scalars.at("s")[vertex], std::abs(mesh_.scalars.at("t")[vertex])};
  }

 private:
  const geometry::TriangleMesh& mesh_;
  NearestVertices tree_;
};

/// A surface by particles that are sent again from the seed curve to wherever it is asked for.
class SentSurface {
 public:
  SentSurface(const SurfaceRequest& request, const SurfaceSetup& setup)
      : request_(request),
        setup_(setup),
        source_(request, setup_),
        noise_(std::max(10 * setup_.trajectory.tolerance,
                        setup_.trajectory.error_floor * setup_.trajectory.duration)) {}

  /// Where the surface ends before t, its last point: t is set back.
  FlowPoint point(double s, double& t);
  SmoothPiece piece_of(const Stretch& stretch);
  /// World units: two trajectories to the same place differ by no more.
  double noise() const { return noise_; }
  ParticleSource& source() { return source_; }

 private:
  const SurfaceRequest& request_;
  SurfaceSetup setup_;
  ParticleSource source_;
  double noise_;
};

/// Steps of an order of 5 are then some 25 times as long as those of the exact surface.
constexpr double quick_tolerance = 1e-6;  // of the extent

SurfaceSetup quick(SurfaceSetup setup) {
  setup.trajectory.tolerance = std::max(setup.trajectory.tolerance, quick_tolerance * setup.extent);
  return setup;
}

class ExactSurface {
 public:
  ExactSurface(const SurfaceRequest& request, const SurfaceSetup& setup,
               const geometry::TriangleMesh& mesh)
      : request_(request), exact_(request, setup), quick_(request, quick(setup)), known_(mesh) {}

  Deviation deviation(const Sample& sample, bool thorough);
  /// Returns by how many degrees a vertex's normal is off; nothing as SurfaceError says.
  std::optional<double> normal_deviation(const geometry::TriangleMesh& mesh, std::uint32_t vertex);
  /// Points of the surface at seed s, spread over the particle's time: none where it has no area,
  /// as at rest or along a seed curve that is a stream line.
  std::vector<Vec3> points_at(double s);

 private:
  using Nearest = NearestPlace;

  std::vector<Place> starts_for(const Sample& sample, const Stretch& stretch) const;
  std::optional<Nearest> exact_from(const Nearest& found, const Stretch& stretch, const Vec3& x);
  Nearest nearest_to(const Sample& sample, const Stretch& stretch, bool thorough);
  Vec3 normal_at(const Nearest& nearest, const Stretch& stretch);

  const SurfaceRequest& request_;
  SentSurface exact_, quick_;
  KnownPlaces known_;
};

FlowPoint SentSurface::point(double s, double& t) {
  Trajectory path = source_.start(s);
  if (!path.exists()) return {request_.seed.point_at(s), Vec3(0), Vec3(0)};
  path.reach(t, source_.sampler());
  t = std::min(t, path.time());
  return path.at(t);
}

std::vector<Vec3> ExactSurface::points_at(double s) {
  constexpr int times = 16;
  std::vector<Vec3> points;
  Trajectory path = exact_.source().start(s);
  if (!path.exists()) return points;
  path.reach(request_.duration, exact_.source().sampler());
  for (int i = 0; i <= times; ++i) {
    const FlowPoint here = path.at(path.time() * i / times);
    if (Tangents(here).span_a_plane()) points.push_back(here.x);
  }
  return points;
}

SmoothPiece SentSurface::piece_of(const Stretch& stretch) {
  return {[&](double s, double& t) { return point(s, t); },
          [&](const Tangents& tangents, const Place& from, const Vec3& off) {
            return move_within(tangents, from, stretch, {0, request_.duration}, off);
          },
          {1e-2, 1e-2 * request_.duration},
          noise_};
}

/// Unit; 0 where there is none. On a crease it is that of the stretch's side.
Vec3 ExactSurface::normal_at(const Nearest& nearest, const Stretch& stretch) {
  constexpr double beside = 1e-7;  // in s: no corner any more
  FlowPoint here = nearest.here;
  if (here.w == Vec3(0)) {
    Place place = nearest.place;
    place.s = std::clamp(place.s, stretch.begin + beside, stretch.end - beside);
    here = exact_.point(place.s, place.t);
  }
  return normal_of(here);
}

/// The places of the facet's corners, and of the vertices around that are on the sample's stretch
/// of the seed curve.
std::vector<Place> ExactSurface::starts_for(const Sample& sample, const Stretch& stretch) const {
  std::vector<Place> starts(sample.corners.begin(), sample.corners.end());
  for (const std::uint32_t vertex : known_.around(sample.x, most_starts)) {
    Place start = known_.place(vertex);
    if (request_.seed.closed) start.s += std::round(sample.middle() - start.s);
    if (stretch.inside(start.s) == start.s) starts.push_back(start);
  }
  return starts;
}

/// Where the sample's own (s, t) leads to no smallest distance, those of its facet's corners do: in
/// a fan about a place of rest what is interpolated between them may be anything.
NearestPlace nearest_from(const Sample& sample, const SmoothPiece& piece) {
  const NearestPlace nearest = nearest_place(piece, sample.place, sample.x);
  return nearest.settled ? nearest : nearest_of(piece, nearest, sample.corners, sample.x);
}

/// The nearest place of the exact surface around what was found on the quick one. Nothing where the
/// quick surface is no guide: it is off by a part of the distance, or leads to a place that is not
/// as near on the exact one.
std::optional<ExactSurface::Nearest> ExactSurface::exact_from(const Nearest& found,
                                                              const Stretch& stretch,
                                                              const Vec3& x) {
  constexpr double part = 0.01, as_near = 1.1;
  if (quick_.noise() > part * found.distance) return {};
  const Nearest there = nearest_place(exact_.piece_of(stretch), found.place, x);
  return there.distance <= as_near * found.distance ? std::optional(there) : std::nullopt;
}

/// What is found may be the smallest distance around alone: where a surface is sheared, or lies
/// over itself, the nearest of all is found from vertices that are near in space, whatever their
/// (s, t). Far from the surface the quick one is searched, and the exact one around what that
/// finds.
ExactSurface::Nearest ExactSurface::nearest_to(const Sample& sample, const Stretch& stretch,
                                               bool thorough) {
  const SmoothPiece exact = exact_.piece_of(stretch), quick = quick_.piece_of(stretch);
  const auto by_quick = exact_from(nearest_from(sample, quick), stretch, sample.x);
  const Nearest nearest = by_quick ? *by_quick : nearest_from(sample, exact);
  if (nearest.distance <= exact_.noise()) return nearest;
  const double to_next = known_.distance(known_.around(sample.x, 1).front(), sample.x);
  if (!thorough && nearest.distance <= doubtful_distance * to_next) return nearest;
  const std::vector<Place> starts = starts_for(sample, stretch);
  if (!by_quick) return nearest_of(exact, nearest, starts, sample.x);
  const Nearest found = nearest_of(quick, nearest, starts, sample.x);
  if (found.distance == nearest.distance) return nearest;
  const auto there = exact_from(found, stretch, sample.x);
  return there ? *there : nearest_of(exact, nearest, starts, sample.x);
}

/// The surface is that of the facet's side of a crease: beyond, its normal would be another one.
Deviation ExactSurface::deviation(const Sample& sample, bool thorough) {
  const Stretch stretch =
      stretch_around(request_.seed.corners, request_.seed.closed, sample.middle());
  const Nearest nearest = nearest_to(sample, stretch, thorough);
  const Vec3 normal = normal_at(nearest, stretch);
  if (normal == Vec3(0) || sample.facet == Vec3(0)) return {nearest.distance, 0};
  return {nearest.distance, degrees_between(normal, sample.facet)};
}

std::optional<double> ExactSurface::normal_deviation(const geometry::TriangleMesh& mesh,
                                                     std::uint32_t vertex) {
  Place place = known_.place(vertex);
  const Vec3 exact = normal_of(exact_.point(place.s, place.t));
  const Vec3 normal = direction_of(mesh.normals[vertex]);
  if (exact == Vec3(0) || normal == Vec3(0)) return {};
  return degrees_between(glm::dot(exact, normal) < 0 ? -exact : exact, normal);
}

/// Fills in how far the normals of some vertices are off.
void measure_normals(const geometry::TriangleMesh& mesh, std::uint64_t samples,
                     ExactSurface& surface, SurfaceError& error) {
  const std::size_t vertices = mesh.normals.size();
  const std::size_t count = std::min<std::size_t>(vertices, samples);
  std::vector<std::optional<double>> degrees(count);
  parallel_for(std::size_t(0), count, [&](std::size_t i) {
    degrees[i] = surface.normal_deviation(mesh, std::uint32_t(i * vertices / count));
  });
  std::erase(degrees, std::nullopt);
  if (degrees.empty()) return;
  double sum = 0, largest = 0;
  for (const std::optional<double>& each : degrees) {
    sum += *each;
    largest = std::max(largest, *each);
  }
  error.vertex_normal_mean_degrees = sum / double(degrees.size());
  error.vertex_normal_max_degrees = largest;
}

/// Points of the surface whatever the mesh is: seeds are the fractions of multiples of 1/φ, which
/// no halving or even spacing comes near to again and again.
std::vector<Vec3> points_of_surface(ExactSurface& surface) {
  constexpr int seeds = 400;
  constexpr double inverse_golden_ratio = 0.61803398874989485;
  std::vector<std::vector<Vec3>> of_seed(seeds);
  parallel_for(0, seeds, [&](int i) {
    const double multiple = (i + 1) * inverse_golden_ratio;
    of_seed[std::size_t(i)] = surface.points_at(multiple - std::floor(multiple));
  });
  std::vector<Vec3> points;
  for (const auto& some : of_seed) points.insert(points.end(), some.begin(), some.end());
  return points;
}

/// What the surface is, whatever made the mesh: all by the tightest integration there is, but for
/// the length at which particles end.
SurfaceSetup exact_setup(const SurfaceRequest& request, const Parameters& integrator) {
  const SurfaceOptions made = surface_options().read(integrator);
  SurfaceOptions exact;
  exact.stepping.length = made.stepping.length;
  exact.stepping.accuracy = made.stepping.accuracy;
  SurfaceSetup setup = surface_setup(request, exact);
  make_exact(setup.trajectory, setup.extent,
             integrator.is_set("tolerance") ? integrator.real("tolerance") : setup.extent);
  return setup;
}

}  // namespace

SurfaceError measure_error(const geometry::TriangleMesh& mesh, const SurfaceRequest& request,
                           std::uint64_t samples, const Parameters& integrator) {
  const SurfaceSetup setup = exact_setup(request, integrator);
  ExactSurface truth(request, setup, mesh);
  const std::vector<MeshSample> chosen = sample_mesh(mesh, samples);
  const auto deviations = search_all(chosen.size(), [&](std::size_t i, bool thorough) {
    return truth.deviation(sample_of(mesh, chosen[i], request.seed.closed), thorough);
  });
  SurfaceError error = surface_error(mesh, chosen, deviations);
  error.max_from_surface = largest_distance(points_of_surface(truth), mesh);
  measure_normals(mesh, samples, truth, error);
  return error;
}

}  // namespace pellucid::integrators
