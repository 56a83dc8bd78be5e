// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/sheets/sheet_error.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "core/parallel.h"
#include "integrators/mesh/facet_normal.h"
#include "integrators/mesh/mesh_distance.h"
#include "integrators/mesh/mesh_samples.h"
#include "integrators/mesh/nearest_vertices.h"
#include "integrators/sheets/integrate_sheet.h"
#include "integrators/sheets/sheet_options.h"
#include "integrators/sheets/sheet_particles.h"
#include "integrators/surfaces/deviation.h"
#include "integrators/surfaces/nearest_place.h"

namespace pellucid::integrators {
namespace {

/// The parameters s and t of the places around a facet: origin + s steps[0] + t steps[1]. Those of
/// a square are the places' own x and y; else the facet's corners are at (0, 0), (1, 0), (0, 1).
struct Chart {
  Vec3 origin{0};
  std::array<Vec3, 2> steps{Vec3(1, 0, 0), Vec3(0, 1, 0)};
  Stretch s, t;
  bool is_facet = false;  // s + t stays within 1

  bool holds(const Place& at) const {
    constexpr double rounding = 1e-9;
    if (is_facet) return std::min({at.s, at.t, 1 - at.s - at.t}) >= -rounding;
    return std::abs(s.inside(at.s) - at.s) <= rounding &&
           std::abs(t.inside(at.t) - at.t) <= rounding;
  }
  Vec3 place(double at_s, double at_t) const { return origin + at_s * steps[0] + at_t * steps[1]; }
  Move move(const Tangents& tangents, const Place& from, const Vec3& off) const {
    if (!is_facet) return move_within(tangents, from, s, t, off);
    return move_within(tangents, from, {0, 1 - from.t}, {0, 1 - from.s}, off);
  }
};

/// A point of the mesh, and the places of its facet's corners on one side of a seam.
struct Sample {
  std::array<Vec3, 3> corners;
  Vec3 place, x, facet;
};

Sample sample_of(const IntegratedSheet& sheet, const SheetDomain& domain, const MeshSample& at) {
  const auto& corners = sheet.mesh.triangles[at.triangle];
  Sample sample;
  sample.corners[0] = sheet.places[corners[0]];
  sample.x = position_of(sheet.mesh, at);
  sample.place = sample.corners[0];
  for (std::size_t k = 1; k < 3; ++k) {
    const Vec3 step = domain.step_between(sample.corners[0], sheet.places[corners[k]]);
    sample.corners[k] = sample.corners[0] + step;
    sample.place += at.barycentric[k] * step;
  }
  const auto x = [&](std::size_t k) { return sheet.mesh.positions[corners[k]]; };
  sample.facet = direction_of(facet_sine(x(0), x(1), x(2)));
  return sample;
}

class ExactSheet {
 public:
  ExactSheet(SheetParticles& particles, const SheetDomain& domain, const IntegratedSheet& sheet)
      : particles_(particles),
        domain_(domain),
        sheet_(sheet),
        vertices_(sheet.mesh.positions),
        noise_(std::max(1e-12 * particles.extent(),
                        particles.options().error_floor * particles.options().duration)) {}

  Deviation deviation(const Sample& sample, bool thorough);

 private:
  Chart chart_of(const Sample& sample) const;
  Place on_chart(const Chart& chart, const Sample& sample, const Vec3& place) const;
  FlowPoint point(const Chart& chart, double s, double t);
  Vec3 normal_at(const Chart& chart, const Place& place);
  SmoothPiece piece_of(const Chart& chart);
  std::vector<Place> starts_for(const Chart& chart, const Sample& sample,
                                std::span<const Vec3> places) const;
  NearestPlace nearest_to(const Chart& chart, const Sample& sample, bool thorough);

  SheetParticles& particles_;
  const SheetDomain& domain_;
  const IntegratedSheet& sheet_;
  NearestVertices vertices_;
  double noise_;  // world units
};

Chart ExactSheet::chart_of(const Sample& sample) const {
  Chart chart;
  if (domain_.is_square) {
    const double middle = (sample.corners[0].x + sample.corners[1].x + sample.corners[2].x) / 3;
    chart.s = stretch_around(domain_.corners, domain_.closed, middle);
    chart.t = {0, 1};
    return chart;
  }
  chart.origin = sample.corners[0];
  chart.steps = {sample.corners[1] - sample.corners[0], sample.corners[2] - sample.corners[0]};
  chart.is_facet = domain_.creased;
  return chart;
}

Place ExactSheet::on_chart(const Chart& chart, const Sample& sample, const Vec3& place) const {
  if (domain_.is_square) return {place.x, place.y};
  const Vec3 off = place - sample.corners[0];
  const FlowPoint basis{Vec3(0), chart.steps[1], chart.steps[0]};
  const Move move = Tangents(basis).move_towards(off);
  return {move.ds, move.dt};
}

/// Where the particle is not there at the end no distance is smaller.
FlowPoint ExactSheet::point(const Chart& chart, double s, double t) {
  const auto slope = particles_.slope_at(chart.place(s, t), chart.steps);
  if (!slope) return {Vec3(std::numeric_limits<double>::max()), Vec3(0), Vec3(0)};
  return {slope->x, slope->along[1], slope->along[0]};
}

/// Unit; 0 where there is none. On a crease it is that of the stretch's side.
Vec3 ExactSheet::normal_at(const Chart& chart, const Place& place) {
  constexpr double beside = 1e-7;  // in s: no corner any more
  const double s = std::clamp(place.s, chart.s.begin + beside, chart.s.end - beside);
  const FlowPoint here = point(chart, s, place.t);
  return Tangents(here).span_a_plane()
             ? direction_of(glm::cross(direction_of(here.w), direction_of(here.v)))
             : Vec3(0);
}

SmoothPiece ExactSheet::piece_of(const Chart& chart) {
  return {[&](double s, double& t) { return point(chart, s, t); },
          [&](const Tangents& tangents, const Place& from, const Vec3& off) {
            return chart.move(tangents, from, off);
          },
          {1e-2, 1e-2},
          noise_};
}

/// Those of the places that the chart holds.
std::vector<Place> ExactSheet::starts_for(const Chart& chart, const Sample& sample,
                                          std::span<const Vec3> places) const {
  std::vector<Place> starts;
  for (const Vec3& place : places) {
    const Vec3 beside = sample.corners[0] + domain_.step_between(sample.corners[0], place);
    const Place start = on_chart(chart, sample, beside);
    if (chart.holds(start)) starts.push_back(start);
  }
  return starts;
}

/// From the sample's own place, its facet's corners and vertices that are near in space, as
/// surfaces are measured (surface_error.cpp).
NearestPlace ExactSheet::nearest_to(const Chart& chart, const Sample& sample, bool thorough) {
  const SmoothPiece piece = piece_of(chart);
  const auto corners = starts_for(chart, sample, sample.corners);
  NearestPlace nearest = nearest_place(piece, on_chart(chart, sample, sample.place), sample.x);
  if (!nearest.settled) nearest = nearest_of(piece, nearest, corners, sample.x);
  if (nearest.distance <= noise_) return nearest;
  const Vec3& next = sheet_.mesh.positions[vertices_.around(sample.x, 1).front()];
  if (!thorough && nearest.distance <= doubtful_distance * glm::distance(next, sample.x))
    return nearest;
  nearest = nearest_of(piece, nearest, corners, sample.x);
  std::vector<Vec3> places;
  for (const std::uint32_t vertex : vertices_.around(sample.x, most_starts))
    places.push_back(sheet_.places[vertex]);
  return nearest_of(piece, nearest, starts_for(chart, sample, places), sample.x);
}

Deviation ExactSheet::deviation(const Sample& sample, bool thorough) {
  const Chart chart = chart_of(sample);
  const NearestPlace nearest = nearest_to(chart, sample, thorough);
  const Vec3 normal = normal_at(chart, nearest.place);
  if (normal == Vec3(0) || sample.facet == Vec3(0)) return {nearest.distance, 0};
  return {nearest.distance, degrees_between(normal, sample.facet)};
}

/// Points of the sheet whatever the mesh is, evenly over its places.
std::vector<Vec3> points_of_sheet(SheetParticles& particles, const SheetDomain& domain) {
  constexpr std::uint64_t count = 4000;
  geometry::TriangleMesh places;
  places.positions = domain.places;
  for (const auto& corners : domain.triangles) places.triangles.push_back(corners);
  std::vector<Vec3> wanted;
  for (const MeshSample& sample : sample_mesh(places, count)) {
    const auto& corners = places.triangles[sample.triangle];
    const Vec3& first = domain.places[corners[0]];
    Vec3 place = first;
    for (std::size_t k = 1; k < 3; ++k)
      place += sample.barycentric[k] * domain.step_between(first, domain.places[corners[k]]);
    if (sample.weight > 0) wanted.push_back(place);
  }
  std::vector<SheetParticle> found(wanted.size());
  parallel_for(std::size_t(0), wanted.size(),
               [&](std::size_t i) { found[i] = particles.at(wanted[i]); });
  std::vector<Vec3> points;
  for (const SheetParticle& particle : found)
    if (particle.is_there()) points.push_back(particle.x);
  return points;
}

/// All by the tightest integration there is, but for the length at which particles end.
SteppingOptions exact_stepping(const SheetOptions& made) {
  SteppingOptions exact;
  exact.length = made.stepping.length;
  exact.accuracy = made.stepping.accuracy;
  return exact;
}

}  // namespace

SurfaceError measure_sheet_error(const IntegratedSheet& sheet, const SheetRequest& request,
                                 std::uint64_t samples, const Parameters& integrator) {
  const SheetOptions made = sheet_options().read(integrator);
  const SheetDomain domain = sheet_domain(request);
  SheetParticles particles(request, domain, exact_stepping(made), std::nullopt);
  particles.be_exact(sheet_tolerance(made, particles.extent()));
  ExactSheet truth(particles, domain, sheet);
  const std::vector<MeshSample> chosen = sample_mesh(sheet.mesh, samples);
  const auto deviations = search_all(chosen.size(), [&](std::size_t i, bool thorough) {
    return truth.deviation(sample_of(sheet, domain, chosen[i]), thorough);
  });
  SurfaceError error = surface_error(sheet.mesh, chosen, deviations);
  error.max_from_surface = largest_distance(points_of_sheet(particles, domain), sheet.mesh);
  return error;
}

}  // namespace pellucid::integrators
