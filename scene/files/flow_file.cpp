// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/flow_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/paths/backward.h"
#include "integrators/surfaces/integrate_surface.h"
#include "scene/files/any_number.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

/// Each form has keys of its own: those of another one would be passed over.
integrators::SeedCurve read_seed(const JsonNode& node) {
  if (node.has("from")) {
    node.accept_keys({"from", "to"});
    return integrators::segment_seed(node["from"].vec3(), node["to"].vec3());
  }
  if (node.has("center")) {
    node.accept_keys({"center", "normal", "radius"});
    return integrators::circle_seed(node["center"].vec3(), node["normal"].vec3(),
                                    node["radius"].number(0, any));
  }
  node.accept_keys({"from", "to", "points", "spline", "closed", "center", "normal", "radius"});
  const bool closed = node.has("closed") && node["closed"].boolean();
  const bool spline = node.has("spline");
  std::vector<Vec3> points;
  for (const JsonNode& point : node[spline ? "spline" : "points"].elements())
    points.push_back(point.vec3());
  return spline ? integrators::spline_seed(points, closed)
                : integrators::polyline_seed(points, closed);
}

FlowSource read_flow(const JsonNode& node, const fs::path& folder) {
  FlowSource source;
  source.field =
      at_place(node["field"], [&] { return fields::make_field(node["field"].string(), folder); });
  source.seed = at_place(node["seed"], [&] { return read_seed(node["seed"]); });
  source.duration = node["duration"].number(-any, any);
  if (node.has("start_time")) source.start_time = node["start_time"].number(-any, any);
  if (node.has("path")) source.path = node["path"].boolean();
  if (source.duration < 0) source.field = fields::reversed(source.field, source.start_time);
  source.duration = std::abs(source.duration);
  return source;
}

/// What a budget has cut short is not what the scene asks for.
void refuse_unfinished(const JsonNode& node, std::string_view smaller,
                       const integrators::EndCounts& ends) {
  const auto budget =
      std::ranges::find_if(ends, [](const auto& end) { return integrators::is_budget(end.first); });
  if (budget == ends.end()) return;
  const std::string_view name = integrators::name_of(budget->first);
  node.fail(
      fmt::format("it is unfinished: max-{} ended {} particles; accepted: {}, a larger max-{}",
                  name, budget->second, smaller, name));
}

}  // namespace

FlowSurface read_flow_surface(const JsonNode& node, const fs::path& folder,
                              const Progress& progress, std::string& how) {
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "path"});
  const std::string integrator = node["integrator"].string();
  FlowSource source = read_flow(node, folder);
  const integrators::SurfaceRequest request{source.field.get(), source.seed, source.duration,
                                            source.start_time,  source.path, progress};
  integrators::IntegratedSurface surface =
      at_place(node, [&] { return integrators::integrate_surface(integrator, request); });
  if (surface.mesh.triangles.empty()) node.fail("nothing to draw: it has no triangle");
  refuse_unfinished(node, "a shorter seed or duration, a coarser threshold or tolerance",
                    surface.stats.ends);
  integrators::turn_back(surface.mesh, *source.field);
  how = fmt::format("{}, {}, {} particles, {} triangles", source.field->description(), integrator,
                    surface.stats.particles, surface.mesh.triangles.size());
  return {std::move(surface.mesh), std::move(source)};
}

geometry::LineSet read_flow_lines(const JsonNode& node, const fs::path& folder,
                                  const Progress& progress, std::string& how) {
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "both"});
  const std::string integrator = node["integrator"].string();
  const FlowSource source = read_flow(node, folder);
  integrators::IntegratedLines made = at_place(node, [&] {
    const integrators::LineRequest request{
        source.field.get(),
        integrators::seeds_on(source.seed, integrators::line_particles(integrator)),
        source.duration,
        source.start_time,
        progress,
        node.has("both") && node["both"].boolean()};
    return integrators::integrate_lines(integrator, request);
  });
  refuse_unfinished(node, "fewer particles, a shorter duration, a longer step or turn",
                    made.stats.ends);
  integrators::turn_back(made.lines, *source.field);
  how = fmt::format("{}, {}, {} lines, {} points", source.field->description(), integrator,
                    made.lines.line_count(), made.lines.positions.size());
  return std::move(made.lines);
}

}  // namespace pellucid::scene
