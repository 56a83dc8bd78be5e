#include "compare/methods/surface_methods.h"

#include <fmt/format.h>

#include "compare/methods/distance_picture.h"
#include "core/error.h"
#include "core/machine/stopwatch.h"
#include "core/options/names.h"
#include "groundtruth/methods/raytrace.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid {
namespace {

/// Enough for a picture of the distance; a sample takes about a millisecond.
constexpr std::uint64_t distance_samples = 4000;

using Better = Measure::Better;

/// The one object that was integrated. Throws InputError.
SceneObject& integrated_object(Scene& scene) {
  SceneObject* found = nullptr;
  int count = 0;
  for (SceneObject& object : scene.objects)
    if (object.source) found = &object, ++count;
  if (count != 1)
    throw InputError(
        fmt::format("scene {}: {} of its objects are integrated surfaces; accepted by surface "
                    "integrators: exactly one",
                    scene.name, count));
  return *found;
}

SurfaceRequest request_of(const FlowSource& source) {
  return {source.field.get(), source.seed, source.duration, source.start_time, source.path, {}};
}

void add_counts(const SurfaceStats& stats, const TriangleMesh& mesh,
                std::vector<Measure>& measures) {
  measures.push_back({"particles", "Particles", "", double(stats.particles), Better::lower});
  measures.push_back({"vertices", "Vertices", "", double(mesh.positions.size()), Better::neither});
  measures.push_back({"triangles", "Triangles", "", double(mesh.triangles.size()), Better::lower});
  measures.push_back(
      {"evaluations", "Evaluations of the field", "", double(stats.evaluations), Better::lower});
  measures.push_back({"surface_seconds", "Integration", "s", stats.seconds, Better::lower});
  measures.push_back(
      {"surface_bytes", "Mesh and trajectories", "bytes", double(stats.bytes), Better::lower});
}

void add_quality(const MeshQuality& quality, std::vector<Measure>& measures) {
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

void add_error(const SurfaceError& error, std::vector<Measure>& measures) {
  const auto add = [&](const char* name, const char* title, double value, const char* unit) {
    measures.push_back({name, title, unit, value, Better::lower});
  };
  add("normal_mean", "Facet normal off, mean", error.normal_mean_degrees, "°");
  add("normal_max", "Facet normal off, largest", error.normal_max_degrees, "°");
  add("distance_mean", "Distance to the exact surface, mean", error.mean, "world units");
  add("distance_rms", "Distance to the exact surface, rms", error.rms, "world units");
  add("distance_max", "Distance to the exact surface, largest", error.max, "world units");
}

/// A column for each way in which a particle can end.
void add_ends(const EndCounts& ends, std::vector<Measure>& measures) {
  for (const auto& [reason, count] : ends)
    measures.push_back({fmt::format("ended_{}", name_of(reason)),
                        fmt::format("Particles ended: {}", name_of(reason)), "", double(count),
                        Better::neither});
}

class SurfaceMethod : public Renderer {
 public:
  SurfaceMethod(const Scene& scene, const IntegratorRow& row, const Parameters& parameters)
      : row_(row),
        parameters_(parameters),
        scene_(scene),
        object_(integrated_object(scene_)),
        request_(request_of(*object_.source)),
        tracing_("raytrace", raytrace_method().parameters, {}) {}

  Rendering render(const RenderRequest& request) override {
    stats_ = integrate();
    const Stopwatch watch;
    const auto tracer = raytrace_method().make(scene_, tracing_, {});
    const double hierarchy = watch.seconds();
    Rendering rendering = tracer->render(request);
    RenderStats& stats = rendering.stats;
    stats.steps.insert(stats.steps.begin(),
                       {{"integrate", stats_.seconds}, {"hierarchy", hierarchy}});
    stats.bytes.insert(stats.bytes.begin(), {"mesh and trajectories", stats_.bytes});
    explanation_ = tracer->explain();
    facts_ = tracer->facts();
    return rendering;
  }

  std::vector<std::string> explain() const override { return explanation_; }
  std::map<std::string, std::string> facts() const override { return facts_; }

  Findings findings() override {
    const TriangleMesh& mesh = object_.mesh();
    Findings findings;
    const SurfaceError error = measure_error(mesh, request_, distance_samples);
    add_counts(stats_, mesh, findings.measures);
    add_quality(measure_quality(mesh), findings.measures);
    add_error(error, findings.measures);
    add_ends(stats_.ends, findings.measures);
    findings.pictures.push_back(distance_picture(scene_, mesh, error.at_vertices));
    return findings;
  }

 private:
  /// The mesh goes to the scene.
  SurfaceStats integrate() {
    IntegratedSurface surface = row_.run(request_, parameters_);
    if (surface.mesh.triangles.empty()) throw WorkError("nothing to draw: it has no triangle");
    apply_appearance(object_.source->appearance, surface.mesh);
    if (scene_.lighting != Lighting::none) ensure_normals(surface.mesh);
    object_.shape = std::move(surface.mesh);
    return surface.stats;
  }

  const IntegratorRow& row_;
  Parameters parameters_;
  Scene scene_;
  SceneObject& object_;  // of scene_
  SurfaceRequest request_;
  Parameters tracing_;
  SurfaceStats stats_;
  std::vector<std::string> explanation_;
  std::map<std::string, std::string> facts_;
};

/// MethodRow::make knows no row: each integrator has its own.
std::unique_ptr<Renderer> make_surface_method(const Scene& scene, const Parameters& parameters,
                                              const RenderContext&) {
  const IntegratorRow& row = find_row("integrator", parameters.owner(), integrators());
  return std::make_unique<SurfaceMethod>(scene, row, parameters);
}

MethodRow method_of(const IntegratorRow& row) {
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

std::span<const MethodRow> surface_methods() {
  static const std::vector<MethodRow> table = [] {
    std::vector<MethodRow> rows;
    for (const IntegratorRow& row : integrators()) rows.push_back(method_of(row));
    return rows;
  }();
  return table;
}

}  // namespace pellucid
