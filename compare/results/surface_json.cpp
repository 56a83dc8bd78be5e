// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/surface_json.h"

#include <nlohmann/json.hpp>

namespace pellucid::compare {
namespace {

nlohmann::ordered_json to_json(const integrators::EndCounts& ends) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const auto& [reason, count] : ends) json[std::string(integrators::name_of(reason))] = count;
  return json;
}

nlohmann::ordered_json to_json(const integrators::Percentiles& values) {
  return {{"p1", values.p1}, {"p50", values.p50}, {"p99", values.p99}, {"max", values.max}};
}

}  // namespace

nlohmann::ordered_json surface_json(const integrators::IntegratedSurface& surface,
                                    const integrators::MeshQuality& quality) {
  return {{"particles", surface.stats.particles},
          {"vertices", surface.mesh.positions.size()},
          {"triangles", surface.mesh.triangles.size()},
          {"evaluations", surface.stats.evaluations},
          {"seconds", surface.stats.seconds},
          {"bytes", surface.stats.bytes},
          {"seed_looks", surface.stats.seed_looks},
          {"trimmed", surface.stats.trimmed},
          {"boundary_edges", quality.boundary_edges},
          {"non_manifold_edges", quality.non_manifold_edges},
          {"misoriented_edges", quality.misoriented_edges},
          {"non_manifold_vertices", quality.non_manifold_vertices},
          {"duplicate_vertices", quality.duplicate_vertices},
          {"degenerate_triangles", quality.degenerate_triangles},
          {"sheets", quality.sheets},
          {"sheets_by_vertices", quality.sheets_by_vertices},
          {"min_angle", to_json(quality.min_angle)},
          {"aspect", to_json(quality.aspect)},
          {"ends", to_json(surface.stats.ends)}};
}

void add_error_json(nlohmann::ordered_json& json, const integrators::SurfaceError& error) {
  json["distance"] = {{"mean", error.mean},
                      {"rms", error.rms},
                      {"max", error.max},
                      {"max_from_surface", error.max_from_surface}};
  json["normal_degrees"] = {{"mean", error.normal_mean_degrees}, {"max", error.normal_max_degrees}};
  if (error.vertex_normal_mean_degrees)
    json["vertex_normal_degrees"] = {{"mean", *error.vertex_normal_mean_degrees},
                                     {"max", *error.vertex_normal_max_degrees}};
  json["samples"] = error.samples;
}

nlohmann::ordered_json lines_json(const integrators::IntegratedLines& lines) {
  return {{"particles", lines.stats.particles},       {"lines", lines.lines.line_count()},
          {"vertices", lines.lines.positions.size()}, {"evaluations", lines.stats.evaluations},
          {"seconds", lines.stats.seconds},           {"bytes", lines.stats.bytes},
          {"ends", to_json(lines.stats.ends)}};
}

}  // namespace pellucid::compare
