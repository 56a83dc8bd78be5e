// SPDX-License-Identifier: GPL-3.0-or-later
// H. Krishnan, C. Garth, K. I. Joy, "Time and Streak Surfaces for Flow Visualization in Large
// Time-Varying Data Sets", IEEE Trans. Vis. Comput. Graph. 15(6), 2009, 1267-1274: particles on a
// triangulation of what they started on, which is refined where it is stretched.
//
// What differs, and why:
// - The paper moves all particles on together, a time step after the other, and halves, collapses
//   and flips edges after each by their length and by what vertices see of their neighbours. New
//   particles start on the mesh of that moment, so that an error once made is carried on. Here a
//   surface at one moment is wanted: each particle is sent from its own seed at its own time, to
//   the tolerance of its trajectory, and the triangulation is refined in the seeds' own parameters
//   until the surface's points lie within a tolerance of it. Nothing has to be collapsed, since
//   nothing was refined for an earlier moment.
// - The paper tears where edges are stretched faster than a rate. Here a sheet is torn where it
//   jumps: where two of its points stay apart however near they are on the seeds; facets are parted
//   there. What is stretched, at whatever rate, is refined.
// - Normals are carried along as dn/dt = -Jᵀ n, the cofactors of the flow's gradient up to a
//   factor, rather than averaged over facets.
#include "integrators/sheets/integrate_sheet.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "integrators/check_surface.h"
#include "integrators/mesh/facet_normal.h"
#include "integrators/mesh/missing_normals.h"
#include "integrators/paths/magnitude.h"
#include "integrators/paths/seeds_along_flow.h"
#include "integrators/paths/trajectory_options.h"
#include "integrators/sheets/sheet_refinement.h"

namespace pellucid::integrators {
namespace {

constexpr std::string_view citation =
    "Krishnan, Garth, Joy, Time and Streak Surfaces for Flow Visualization in Large Time-Varying "
    "Data Sets, 2009";

void check(const SheetIntegratorRow& row, const SheetRequest& request) {
  const bool by_curve = row.seed == SheetSeed::curve;
  if (!request.field) throw InputError(fmt::format("{}: a field is needed", row.name));
  if (by_curve ? !request.curve : !request.surface)
    throw InputError(fmt::format("{}: accepted: seeds on {}", row.name,
                                 by_curve ? "a curve" : "a surface: a patch, a sphere or a mesh"));
}

/// Particles of a curve are let go all the time, and the flow may cross it at any.
void check_seeds(std::string_view name, const SheetRequest& request) {
  constexpr int releases = 33;
  std::vector<double> times{request.start_time};
  for (int i = 1; i < releases && !request.field->steady(); ++i)
    times.push_back(request.start_time + request.duration * i / (releases - 1));
  if (request.curve) check_across_flow(name, *request.curve, *request.field, times);
}

/// Numbers the vertices that facets have, in the order in which they come.
class Used {
 public:
  explicit Used(std::size_t count) : numbers_(count, unused) {}

  std::uint32_t number(std::uint32_t vertex) {
    if (numbers_[vertex] == unused) {
      numbers_[vertex] = std::uint32_t(vertices_.size());
      vertices_.push_back(vertex);
    }
    return numbers_[vertex];
  }
  const std::vector<std::uint32_t>& vertices() const { return vertices_; }

 private:
  static constexpr std::uint32_t unused = ~0u;
  std::vector<std::uint32_t> numbers_, vertices_;
};

void add_vertex(IntegratedSheet& sheet, const SheetVertex& vertex, const SheetRequest& request,
                const SheetDomain& domain) {
  const auto& [place, particle] = vertex;
  const double end = request.start_time + request.duration;
  sheet.places.push_back(place);
  sheet.mesh.positions.push_back(particle.x);
  sheet.mesh.normals.push_back(direction_of(particle.normal));
  auto& scalars = sheet.mesh.scalars;
  scalars["t"].push_back(particle.age);
  scalars["time"].push_back(end);
  scalars["released"].push_back(end - particle.age);
  scalars["speed"].push_back(magnitude(particle.v));
  if (request.curve) scalars["s"].push_back(place.x);
  if (!request.curve && domain.is_square) {
    scalars["u"].push_back(place.x);
    scalars["v"].push_back(place.y);
  }
}

void add_facets(IntegratedSheet& sheet, const std::vector<Facet>& facets,
                const SheetRefinement& refined, const SheetRequest& request,
                const SheetDomain& domain) {
  Used used(refined.vertices().size());
  const auto x = [&](std::uint32_t vertex) { return refined.vertices()[vertex].particle.x; };
  for (const Facet& facet : facets)
    if (has_area(x(facet[0]), x(facet[1]), x(facet[2])))
      sheet.mesh.triangles.push_back(
          {used.number(facet[0]), used.number(facet[1]), used.number(facet[2])});
  for (const std::uint32_t vertex : used.vertices())
    add_vertex(sheet, refined.vertices()[vertex], request, domain);
  fill_missing_normals(sheet.mesh.positions, sheet.mesh.triangles, sheet.mesh.normals);
}

/// Ends are those of the mesh's vertices and of the places whose particles are gone. Not of those
/// that are there beside a border and in no facet, unless nobody is in any.
EndCounts ends_of(const SheetRefinement& refined, const geometry::TriangleMesh& mesh) {
  EndCounts ends;
  for (const SheetVertex& vertex : refined.vertices())
    if (vertex.particle.lost || mesh.positions.empty())
      ++ends[vertex.particle.lost.value_or(EndReason::duration)];
  if (!mesh.positions.empty()) ends[EndReason::duration] = mesh.positions.size();
  return ends;
}

SurfaceStats stats_of(const SheetRefinement& refined, std::uint64_t torn,
                      const SheetParticles& particles, const geometry::TriangleMesh& mesh) {
  SurfaceStats stats;
  stats.particles = particles.sent();
  stats.evaluations = particles.evaluations();
  stats.bytes = refined.bytes();
  stats.ends = ends_of(refined, mesh);
  if (torn > 0) stats.ends[EndReason::torn] = torn;
  if (refined.budget()) stats.ends[*refined.budget()] = refined.unfinished();
  return stats;
}

}  // namespace

std::span<const SheetIntegratorRow> sheet_integrators() {
  static const auto specs = sheet_options().specs();
  static const SheetIntegratorRow table[] = {
      {"streak-surface", "Streak surface: particles let go along a curve one after another",
       citation, specs, SheetSeed::curve},
      {"time-surface", "Time surface: particles let go at once all over a surface", citation, specs,
       SheetSeed::surface}};
  return table;
}

Parameters sheet_parameters(std::string_view integrator) {
  const NameAndOptions parsed = parse_name_and_options(integrator);
  const SheetIntegratorRow& row = find_row("integrator", parsed.name, sheet_integrators());
  return Parameters(row.name, row.parameters, parsed.options);
}

SheetDomain sheet_domain(const SheetRequest& request) {
  return request.curve ? streak_domain(*request.curve, request.duration)
                       : time_domain(*request.surface, request.duration);
}

IntegratedSheet integrate_sheet(std::string_view integrator, const SheetRequest& request) {
  const Stopwatch watch;
  const Parameters parameters = sheet_parameters(integrator);
  const SheetIntegratorRow& row = find_row("integrator", parameters.owner(), sheet_integrators());
  check(row, request);
  const SheetOptions options = sheet_options().read(parameters);
  if (options.tolerance) positive("tolerance", options.tolerance, 0);
  check_keeps_tolerance(options.stepping, options.tolerance);
  check_end(*request.field, {request.duration, request.start_time, true});
  check_seeds(row.name, request);
  const SheetDomain domain = sheet_domain(request);
  SheetParticles particles(request, domain, options.stepping, options.tolerance);
  SheetRefinement refined(particles, domain, options, sheet_tolerance(options, particles.extent()),
                          request.progress);
  refined.run();
  const auto [facets, torn] = refined.facets();
  IntegratedSheet sheet;
  add_facets(sheet, facets, refined, request, domain);
  sheet.stats = stats_of(refined, torn, particles, sheet.mesh);
  sheet.stats.seconds = watch.seconds();
  check_surface(row.name, sheet, *request.field);
  return sheet;
}

}  // namespace pellucid::integrators
