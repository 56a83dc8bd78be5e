// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/methods/surface_methods.h"

#include <fmt/format.h>

#include "compare/methods/distance_picture.h"
#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "groundtruth/methods/raytrace.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/paths/backward.h"
#include "integrators/paths/carried.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"
#include "scene/elements/opacity_source.h"

namespace pellucid::compare {
namespace {

/// Enough for a picture of the distance; a sample takes about a millisecond.
constexpr std::uint64_t distance_samples = 4000;

using Better = scene::Measure::Better;

/// The one object that was integrated. Throws InputError, also where its opacities were optimized:
/// they are those of its mesh's vertices, and another mesh has others.
scene::SceneObject& integrated_object(scene::Scene& scene) {
  if (scene::has_optimized_opacities(scene))
    throw InputError(fmt::format(
        "scene {}: its opacities were optimized for the meshes that it has; accepted by "
        "surface integrators, which make another: a scene's own opacities",
        scene.name));
  scene::SceneObject* found = nullptr;
  int count = 0;
  for (scene::SceneObject& object : scene.objects)
    if (object.source) found = &object, ++count;
  if (count != 1)
    throw InputError(
        fmt::format("scene {}: {} of its objects are integrated surfaces; accepted by surface "
                    "integrators: exactly one",
                    scene.name, count));
  return *found;
}

integrators::SurfaceRequest request_of(const scene::FlowSource& source) {
  return {source.field.get(), source.seed, source.duration, source.start_time, source.path, {}};
}

void add_counts(const integrators::SurfaceStats& stats, const geometry::TriangleMesh& mesh,
                std::vector<scene::Measure>& measures) {
  measures.push_back({"particles", "Particles", "", double(stats.particles), Better::lower});
  measures.push_back({"vertices", "Vertices", "", double(mesh.positions.size()), Better::neither});
  measures.push_back({"triangles", "Triangles", "", double(mesh.triangles.size()), Better::lower});
  measures.push_back(
      {"evaluations", "Evaluations of the field", "", double(stats.evaluations), Better::lower});
  measures.push_back({"surface_seconds", "Integration", "s", stats.seconds, Better::lower});
  measures.push_back(
      {"surface_bytes", "Mesh and trajectories", "bytes", double(stats.bytes), Better::lower});
}

void add_quality(const integrators::MeshQuality& quality, std::vector<scene::Measure>& measures) {
  const auto add = [&](const char* name, const char* title, double value, Better better,
                       const char* unit = "") {
    measures.push_back({name, title, unit, value, better});
  };
  add("sheets", "Sheets", double(quality.sheets), Better::lower);
  add("boundary_edges", "Boundary edges", double(quality.boundary_edges), Better::neither);
  add("non_manifold_edges", "Non-manifold edges", double(quality.non_manifold_edges),
      Better::lower);
  add("degenerate_triangles", "Triangles without area", double(quality.degenerate_triangles),
      Better::lower);
  add("min_angle_p1", "Smallest angle, 1st percentile", quality.min_angle.p1, Better::higher, "°");
  add("min_angle_p50", "Smallest angle, median", quality.min_angle.p50, Better::higher, "°");
  add("aspect_p50", "Aspect ratio, median", quality.aspect.p50, Better::lower);
  add("aspect_p99", "Aspect ratio, 99th percentile", quality.aspect.p99, Better::lower);
}

void add_error(const integrators::SurfaceError& error, std::vector<scene::Measure>& measures) {
  const auto add = [&](const char* name, const char* title, double value, const char* unit) {
    measures.push_back({name, title, unit, value, Better::lower});
  };
  add("normal_mean", "Facet normal off, mean", error.normal_mean_degrees, "°");
  add("normal_max", "Facet normal off, largest", error.normal_max_degrees, "°");
  if (error.vertex_normal_mean_degrees) {
    add("vertex_normal_mean", "Vertex normal off, mean", *error.vertex_normal_mean_degrees, "°");
    add("vertex_normal_max", "Vertex normal off, largest", *error.vertex_normal_max_degrees, "°");
  }
  add("distance_mean", "Distance to the exact surface, mean", error.mean, "world units");
  add("distance_rms", "Distance to the exact surface, rms", error.rms, "world units");
  add("distance_max", "Distance to the exact surface, largest", error.max, "world units");
}

/// A column for each way in which a particle can end.
void add_ends(const integrators::EndCounts& ends, std::vector<scene::Measure>& measures) {
  for (const auto& [reason, count] : ends)
    measures.push_back({fmt::format("ended_{}", integrators::name_of(reason)),
                        fmt::format("Particles ended: {}", integrators::name_of(reason)), "",
                        double(count), Better::neither});
}

class SurfaceMethod : public scene::Renderer {
 public:
  SurfaceMethod(const scene::Scene& scene, const integrators::IntegratorRow& row,
                const Parameters& parameters)
      : row_(row),
        parameters_(parameters),
        scene_(scene),
        object_(integrated_object(scene_)),
        request_(request_of(*object_.source)),
        tracing_("raytrace", groundtruth::raytrace_method().parameters, {}) {}

  scene::Rendering render(const scene::RenderRequest& request) override {
    stats_ = integrate();
    const Stopwatch watch;
    const auto tracer = groundtruth::raytrace_method().make(scene_, tracing_, {});
    const double hierarchy = watch.seconds();
    scene::Rendering rendering = tracer->render(request);
    scene::RenderStats& stats = rendering.stats;
    stats.steps.insert(stats.steps.begin(),
                       {{"integrate", stats_.seconds}, {"hierarchy", hierarchy}});
    stats.bytes.insert(stats.bytes.begin(), {"mesh and trajectories", stats_.bytes});
    explanation_ = tracer->explain();
    facts_ = tracer->facts();
    return rendering;
  }

  std::vector<std::string> explain() const override { return explanation_; }
  std::map<std::string, std::string> facts() const override { return facts_; }

  scene::Findings findings() override {
    const geometry::TriangleMesh& mesh = object_.mesh();
    scene::Findings findings;
    const integrators::SurfaceError error =
        integrators::measure_error(mesh, request_, distance_samples, parameters_);
    add_counts(stats_, mesh, findings.measures);
    add_quality(integrators::measure_quality(mesh), findings.measures);
    add_error(error, findings.measures);
    add_ends(stats_.ends, findings.measures);
    findings.pictures.push_back(distance_picture(scene_, mesh, error.at_vertices));
    return findings;
  }

 private:
  /// The mesh goes to the scene.
  integrators::SurfaceStats integrate() {
    integrators::IntegratedSurface surface = row_.run(request_, parameters_);
    if (surface.mesh.triangles.empty()) throw WorkError("nothing to draw: it has no triangle");
    integrators::turn_back(surface.mesh, *object_.source->field);
    if (object_.source->attributes)
      integrators::carry(*object_.source->attributes, surface.mesh.positions, surface.mesh);
    scene::apply_appearance(object_.source->appearance, surface.mesh);
    if (scene::lighting_of(scene_, object_) != scene::Lighting::none)
      scene::ensure_normals(surface.mesh);
    object_.shape = std::move(surface.mesh);
    return surface.stats;
  }

  const integrators::IntegratorRow& row_;
  Parameters parameters_;
  scene::Scene scene_;
  scene::SceneObject& object_;  // of scene_
  integrators::SurfaceRequest request_;
  Parameters tracing_;
  integrators::SurfaceStats stats_;
  std::vector<std::string> explanation_;
  std::map<std::string, std::string> facts_;
};

/// MethodRow::make knows no row: each integrator has its own.
std::unique_ptr<scene::Renderer> make_surface_method(const scene::Scene& scene,
                                                     const Parameters& parameters,
                                                     const scene::RenderContext&) {
  const integrators::IntegratorRow& row =
      find_row("integrator", parameters.owner(), integrators::integrators());
  return std::make_unique<SurfaceMethod>(scene, row, parameters);
}

scene::MethodRow method_of(const integrators::IntegratorRow& row) {
  return {.name = row.name,
          .title = row.title,
          .citation = row.citation,
          .equations = "",
          .parameters = row.parameters,
          .promises = {},
          .bytes_per_pixel = "",
          .make = make_surface_method};
}

}  // namespace

std::span<const scene::MethodRow> surface_methods() {
  static const std::vector<scene::MethodRow> table = [] {
    std::vector<scene::MethodRow> rows;
    for (const integrators::IntegratorRow& row : integrators::integrators())
      rows.push_back(method_of(row));
    return rows;
  }();
  return table;
}

}  // namespace pellucid::compare
