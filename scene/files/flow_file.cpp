// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/flow_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fields/make_field.h"
#include "fields/readers/attributes.h"
#include "fields/readers/file_field.h"
#include "fields/reversed_field.h"
#include "geometry/files/mesh_file.h"
#include "integrators/integrator_kind.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/paths/backward.h"
#include "integrators/paths/carried.h"
#include "integrators/sheets/integrate_sheet.h"
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

/// Likewise, of the particles of a time surface.
integrators::SeedSurface read_seed_surface(const JsonNode& node, const fs::path& folder) {
  if (node.has("mesh")) {
    node.accept_keys({"mesh"});
    return integrators::mesh_seed(at_place(
        node["mesh"], [&] { return geometry::read_mesh(folder / node["mesh"].string()); }));
  }
  if (node.has("center")) {
    node.accept_keys({"center", "radius"});
    return integrators::sphere_seed(node["center"].vec3(), node["radius"].number(0, any));
  }
  node.accept_keys({"corner", "u", "v", "center", "radius", "mesh"});
  return integrators::patch_seed(node["corner"].vec3(), node["u"].vec3(), node["v"].vec3());
}

/// A Flow is what particles of any kind go by.
struct Flow {
  std::shared_ptr<const fields::VectorField> field;
  double duration = 0;  // > 0: a way back is one in the reversed field
  double start_time = 0;
};

Flow read_flow(const JsonNode& node, const fs::path& folder) {
  Flow flow;
  flow.field =
      at_place(node["field"], [&] { return fields::make_field(node["field"].string(), folder); });
  flow.duration = node["duration"].number(-any, any);
  if (node.has("start_time")) flow.start_time = node["start_time"].number(-any, any);
  if (flow.duration < 0) flow.field = fields::reversed(flow.field, flow.start_time);
  flow.duration = std::abs(flow.duration);
  return flow;
}

integrators::SeedCurve read_seed_curve(const JsonNode& node) {
  return at_place(node["seed"], [&] { return read_seed(node["seed"]); });
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

using AttributesOfFile = std::shared_ptr<const fields::Attributes>;

/// Of the scalars that the appearance is by, those that were not integrated are the field's files'.
/// A field that is no file has none: what is missing is refused where colours are applied.
AttributesOfFile carry_attributes(const JsonNode& node, const FlowContext& context,
                                  geometry::Vertices& vertices) {
  std::vector<std::string> own, others;
  for (const auto& [name, values] : vertices.scalars) own.push_back(name);
  for (const std::string& name : context.scalars)
    if (!vertices.scalars.contains(name) && std::ranges::find(others, name) == others.end())
      others.push_back(name);
  const std::string field = node["field"].string();
  if (others.empty() || !fields::names_file(field)) return nullptr;
  try {
    auto attributes = std::make_shared<const fields::Attributes>(field, context.folder, others);
    integrators::carry(*attributes, vertices.positions, vertices);
    return attributes;
  } catch (const InputError& error) {
    node["field"].fail(
        fmt::format("{}; what is integrated has {}", error.what(), fmt::join(own, ", ")));
  }
}

/// What is drawn of a surface, once it is whole.
geometry::TriangleMesh finished(const JsonNode& node, const std::string& integrator,
                                const fields::VectorField& field,
                                integrators::IntegratedSurface surface, std::string& how) {
  if (surface.mesh.triangles.empty()) node.fail("nothing to draw: it has no triangle");
  refuse_unfinished(node, "a shorter seed or duration, a coarser threshold or tolerance",
                    surface.stats.ends);
  integrators::turn_back(surface.mesh, field);
  how = fmt::format("{}, {}, {} particles, {} triangles", field.description(), integrator,
                    surface.stats.particles, surface.mesh.triangles.size());
  return std::move(surface.mesh);
}

FlowSurface read_swept_surface(const JsonNode& node, const std::string& integrator, Flow flow,
                               const FlowContext& context, std::string& how) {
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "path"});
  FlowSource source;
  source.field = std::move(flow.field);
  source.seed = read_seed_curve(node);
  source.duration = flow.duration;
  source.start_time = flow.start_time;
  if (node.has("path")) source.path = node["path"].boolean();
  const integrators::SurfaceRequest request{source.field.get(), source.seed, source.duration,
                                            source.start_time,  source.path, context.progress};
  integrators::IntegratedSurface surface =
      at_place(node, [&] { return integrators::integrate_surface(integrator, request); });
  geometry::TriangleMesh mesh = finished(node, integrator, *source.field, std::move(surface), how);
  source.attributes = carry_attributes(node, context, mesh);
  return {std::move(mesh), std::move(source)};
}

FlowSurface read_sheet(const JsonNode& node, const std::string& integrator, const Flow& flow,
                       bool of_curve, const FlowContext& context, std::string& how) {
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time"});
  integrators::SheetRequest request;
  request.field = flow.field.get();
  if (of_curve)
    request.curve = read_seed_curve(node);
  else
    request.surface =
        at_place(node["seed"], [&] { return read_seed_surface(node["seed"], context.folder); });
  request.duration = flow.duration;
  request.start_time = flow.start_time;
  request.progress = context.progress;
  integrators::IntegratedSurface surface =
      at_place(node, [&] { return integrators::integrate_sheet(integrator, request); });
  geometry::TriangleMesh mesh = finished(node, integrator, *flow.field, std::move(surface), how);
  carry_attributes(node, context, mesh);
  return {std::move(mesh), std::nullopt};
}

}  // namespace

FlowSurface read_flow_surface(const JsonNode& node, const FlowContext& context, std::string& how) {
  using integrators::IntegratorKind;
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "path"});
  const std::string integrator = node["integrator"].string();
  const auto kind =
      at_place(node["integrator"], [&] { return integrators::integrator_kind(integrator); });
  if (kind == IntegratorKind::lines)
    node["integrator"].fail("it draws lines; accepted: an integrator of surfaces");
  Flow flow = read_flow(node, context.folder);
  if (!integrators::is_sheet(kind))
    return read_swept_surface(node, integrator, std::move(flow), context, how);
  return read_sheet(node, integrator, flow, kind == IntegratorKind::streak_sheet, context, how);
}

geometry::LineSet read_flow_lines(const JsonNode& node, const FlowContext& context,
                                  std::string& how) {
  node.accept_keys({"field", "integrator", "seed", "duration", "start_time", "both"});
  const std::string integrator = node["integrator"].string();
  const Flow flow = read_flow(node, context.folder);
  const integrators::SeedCurve seed = read_seed_curve(node);
  integrators::IntegratedLines made = at_place(node, [&] {
    const integrators::LineRequest request{
        flow.field.get(), integrators::seeds_on(seed, integrators::line_particles(integrator)),
        flow.duration,    flow.start_time,
        context.progress, node.has("both") && node["both"].boolean()};
    return integrators::integrate_lines(integrator, request);
  });
  refuse_unfinished(node, "fewer particles, a shorter duration, a longer step or turn",
                    made.stats.ends);
  integrators::turn_back(made.lines, *flow.field);
  carry_attributes(node, context, made.lines);
  how = fmt::format("{}, {}, {} lines, {} points", flow.field->description(), integrator,
                    made.lines.line_count(), made.lines.positions.size());
  return std::move(made.lines);
}

}  // namespace pellucid::scene
