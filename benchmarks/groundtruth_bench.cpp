// SPDX-License-Identifier: GPL-3.0-or-later
// `raytrace` against Embree's bare all-hit traversal: the same rays over the same triangles as
// built-in primitives, every hit recorded by a filter function, sorted and thrown away. Both are
// timed in turn in one run with the same threads; `ratio` (median of the pairs) is what counts.
#include <benchmark/benchmark.h>
#include <tbb/blocked_range2d.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>

#include "core/machine/stopwatch.h"
#include "groundtruth/methods/raytrace.h"
#include "groundtruth/shapes/crossing_geometry.h"
#include "groundtruth/traversal/crossing_finder.h"
#include "groundtruth/traversal/embree.h"
#include "scene/files/scene_file.h"

namespace pellucid {
namespace {

/// `layers` wavy sheets of 2 × 150 × 150 triangles over the whole picture.
scene::Scene wavy_sheets(int layers) {
  constexpr std::uint32_t cells = 150;
  scene::Scene scene;
  scene.camera.fov = 25;
  for (int i = 0; i < layers; ++i) {
    geometry::TriangleMesh mesh;
    for (std::uint32_t v = 0; v <= cells; ++v)
      for (std::uint32_t u = 0; u <= cells; ++u) {
        const double x = 2.6 * u / cells - 1.3, y = 2.6 * v / cells - 1.3;
        const double wave = 0.2 * std::sin(5 * x + i) * std::cos(4 * y - i);
        mesh.positions.emplace_back(x, y, 1 - 2.0 * i / layers + wave);
        mesh.colors.emplace_back(float(i) / float(layers), 0.5f, 0.3f, 0.1f);
      }
    for (std::uint32_t v = 0; v < cells; ++v)
      for (std::uint32_t u = 0; u < cells; ++u) {
        const std::uint32_t a = v * (cells + 1) + u, b = a + cells + 1;
        mesh.triangles.push_back({a, a + 1, b + 1});
        mesh.triangles.push_back({a, b + 1, b});
      }
    scene.objects.push_back({"sheet", std::move(mesh)});
  }
  return scene;
}

struct BareHit {
  float t;
  unsigned object, triangle;
  float u, v;
};

struct BareContext {
  groundtruth::EmbreeContext embree;
  std::vector<BareHit>* hits;
};

void record(const RTCFilterFunctionNArguments* args) {
  RTCRayN* ray = args->ray;
  RTCHitN* hit = args->hit;
  reinterpret_cast<BareContext*>(args->context)
      ->hits->push_back({RTCRayN_tfar(ray, args->N, 0), RTCHitN_geomID(hit, args->N, 0),
                         RTCHitN_primID(hit, args->N, 0), RTCHitN_u(hit, args->N, 0),
                         RTCHitN_v(hit, args->N, 0)});
  args->valid[0] = 0;
}

/// Built-in triangles in float.
class BareTraversal {
 public:
  BareTraversal(const scene::Scene& from, bool robust)
      : width_(from.width),
        height_(from.height),
        rays_(from.camera, from.width, from.height),
        device_(rtcNewDevice(nullptr)),
        scene_(rtcNewScene(device_)) {
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    for (const scene::SceneObject& object : from.objects) attach(object.mesh());
    rtcCommitScene(scene_);
  }
  ~BareTraversal() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  BareTraversal(const BareTraversal&) = delete;
  BareTraversal& operator=(const BareTraversal&) = delete;

  std::uint64_t run() const {
    std::atomic<std::uint64_t> total = 0;
    tbb::enumerable_thread_specific<std::vector<BareHit>> buffers;
    tbb::parallel_for(tbb::blocked_range2d<int>(0, height_, 16, 0, width_, 16), [&](const auto& r) {
      std::vector<BareHit>& hits = buffers.local();
      std::uint64_t count = 0;
      for (int y = r.rows().begin(); y < r.rows().end(); ++y)
        for (int x = r.cols().begin(); x < r.cols().end(); ++x) count += trace(x, y, hits);
      total += count;
    });
    return total;
  }

 private:
  void attach(const geometry::TriangleMesh& mesh) {
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, mesh.positions.size()));
    for (const Vec3& x : mesh.positions)
      for (int k = 0; k < 3; ++k) *vertices++ = float(x[k]);
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                            12, mesh.triangles.size());
    std::copy(mesh.triangles.begin(), mesh.triangles.end(),
              static_cast<std::array<std::uint32_t, 3>*>(indices));
    rtcSetGeometryOccludedFilterFunction(geometry, record);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }

  std::uint64_t trace(int x, int y, std::vector<BareHit>& hits) const {
    hits.clear();
    const scene::Ray ray = rays_.ray(x + 0.5, y + 0.5);
    BareContext context{{}, &hits};
    groundtruth::start(context.embree);
    RTCRay r{};
    r.org_x = float(ray.origin.x), r.org_y = float(ray.origin.y), r.org_z = float(ray.origin.z);
    r.dir_x = float(ray.direction.x), r.dir_y = float(ray.direction.y);
    r.dir_z = float(ray.direction.z);
    r.tfar = std::numeric_limits<float>::infinity();
    r.mask = ~0u;
    groundtruth::traverse_occluded(scene_, context.embree, r);
    std::sort(hits.begin(), hits.end(),
              [](const BareHit& p, const BareHit& q) { return p.t < q.t; });
    return hits.size();
  }

  int width_, height_;
  scene::RayGenerator rays_;
  RTCDevice device_;
  RTCScene scene_;
};

double seconds_of(const auto& work) {
  const Stopwatch watch;
  work();
  return watch.seconds();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Times `tested` and `bare` in turn.
void in_pairs(benchmark::State& state, const auto& tested, const auto& bare) {
  tested(), bare();  // warm-up
  std::vector<double> ratios, bare_times;
  for (auto _ : state) {
    const double seconds = seconds_of(tested);
    state.SetIterationTime(seconds);
    bare_times.push_back(seconds_of(bare));
    ratios.push_back(seconds / bare_times.back());
  }
  state.counters["ratio"] = median(ratios);
  state.counters["bare_ms"] = 1e3 * median(bare_times);
}

void against_bare(benchmark::State& state, const scene::Scene& scene, const std::string& precision,
                  bool robust) {
  const scene::MethodRow& row = groundtruth::raytrace_method();
  const auto renderer =
      row.make(scene, Parameters(row.name, row.parameters, {{"precision", precision}}), {});
  const BareTraversal bare(scene, robust);
  in_pairs(
      state, [&] { benchmark::DoNotOptimize(renderer->render({}).image.pixels.data()); },
      [&] { benchmark::DoNotOptimize(bare.run()); });
  state.counters["crossings"] = double(renderer->render({}).stats.fragments);
}

/// Finding and ordering alone: what is left of the ratio is the composite's.
void crossings_against_bare(benchmark::State& state, const scene::Scene& scene) {
  const groundtruth::CrossingFinder finder(scene, groundtruth::Precision::exact);
  const BareTraversal bare(scene, true);
  using Buffers = std::array<std::vector<groundtruth::Crossing>, groundtruth::RayPacket::width>;
  const auto find_all = [&] {
    tbb::enumerable_thread_specific<Buffers> buffers;
    // A packet is 4 x 4 pixels; a task 16 x 16.
    tbb::parallel_for(
        tbb::blocked_range2d<int>(0, (scene.height + 3) / 4, 4, 0, (scene.width + 3) / 4, 4),
        [&](const auto& r) {
          std::vector<groundtruth::PictureRay> rays;
          for (int py = r.rows().begin(); py < r.rows().end(); ++py)
            for (int px = r.cols().begin(); px < r.cols().end(); ++px) {
              rays.clear();
              for (int y = 4 * py; y < std::min(4 * py + 4, scene.height); ++y)
                for (int x = 4 * px; x < std::min(4 * px + 4, scene.width); ++x)
                  rays.push_back(finder.frame().ray(x + 0.5, y + 0.5));
              finder.find(rays, std::span(buffers.local()).first(rays.size()));
            }
        });
  };
  in_pairs(state, find_all, [&] { benchmark::DoNotOptimize(bare.run()); });
}

void one_thread_against_two(benchmark::State& state) {
  const scene::Scene scene = wavy_sheets(8);
  const scene::MethodRow& row = groundtruth::raytrace_method();
  const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
  const auto with_threads = [&](int count) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, count);
    renderer->render({});
  };
  in_pairs(
      state, [&] { with_threads(1); }, [&] { with_threads(2); });
}

/// The eighth of 64 sheets opaque, against all transparent: what lies behind is not visited.
void opaque_against_transparent(benchmark::State& state) {
  const scene::Scene transparent = wavy_sheets(64);
  scene::Scene opaque = transparent;
  opaque.objects[7].opaque = true;
  const scene::MethodRow& row = groundtruth::raytrace_method();
  const Parameters parameters(row.name, row.parameters, {});
  const auto tested = row.make(opaque, parameters, {}), all = row.make(transparent, parameters, {});
  in_pairs(
      state, [&] { tested->render({}); }, [&] { all->render({}); });
  state.counters["crossings"] = double(tested->render({}).stats.fragments);
}

void register_scene(const std::string& name, const scene::Scene& scene) {
  benchmark::RegisterBenchmark(
      (name + "/crossings-only/against-robust").c_str(),
      [&scene](benchmark::State& state) { crossings_against_bare(state, scene); })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(5);
  for (const char* precision : {"exact", "double", "fast"})
    for (const bool robust : {true, false})
      benchmark::RegisterBenchmark(
          (name + "/" + precision + "/" + (robust ? "against-robust" : "against-fast")).c_str(),
          [&scene, precision, robust](benchmark::State& state) {
            against_bare(state, scene, precision, robust);
          })
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond)
          ->Iterations(5);
}

}  // namespace
}  // namespace pellucid

int main(int argc, char** argv) {
  using namespace pellucid;
  benchmark::Initialize(&argc, argv);
  // A scene file may follow the options, e.g. scenes/abc.json.
  const scene::Scene few = wavy_sheets(8), many = wavy_sheets(64);
  register_scene("sheets-8", few);
  register_scene("sheets-64", many);
  scene::Scene file;
  if (argc > 1) {
    file = scene::load_scene(argv[1]);
    register_scene(file.name, file);
  }
  benchmark::RegisterBenchmark("opaque-8th-of-64-against-none", opaque_against_transparent)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(5);
  benchmark::RegisterBenchmark("threads-1-against-2", one_thread_against_two)
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond)
      ->Iterations(5);
  benchmark::RunSpecifiedBenchmarks();
}
