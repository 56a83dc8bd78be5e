// SPDX-License-Identifier: GPL-3.0-or-later
// `raytrace` at the papers' sizes: the build of the hierarchy and one picture of 1000², with the
// largest resident memory of the process meanwhile, the scene's own data included.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <fstream>
#include <string>

#include "core/machine/stopwatch.h"
#include "core/parallel.h"
#include "fields/make_field.h"
#include "groundtruth/methods/raytrace.h"
#include "scene/datasets/dataset.h"

namespace {

using namespace pellucid;

/// Linux forgets the peak of a process that writes 5 here (proc(5)).
void forget_peak_memory() { std::ofstream("/proc/self/clear_refs") << '5'; }

/// VmHWM of /proc/self/status, in bytes.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (word == "VmHWM:" && status >> word) return 1024 * std::stod(word);
  return 0;
}

/// Looks at [0, 2π]³ along its diagonal.
scene::Camera abc_camera() {
  return {.eye = Vec3(14, 11, 17), .target = Vec3(3.14), .up = {0, 0, 1}, .fov = 30};
}

/// 32 000 stream lines of the ABC flow, 500 segments each: classical RK4, one step a segment.
geometry::LineSet abc_lines() {
  constexpr std::size_t lines = 32000, segments = 500;
  constexpr double step = 0.004;
  geometry::LineSet set;
  set.positions.resize(lines * (segments + 1));
  set.colors.assign(set.positions.size(), Rgba(0.2, 0.4, 0.8, 0.1));
  for (std::size_t k = 1; k <= lines; ++k) set.offsets.push_back(k * (segments + 1));
  const auto field = fields::make_field("abc");
  parallel_ranges(tbb::blocked_range<std::size_t>(0, lines), [&](const auto& range) {
    const auto sampler = field->sampler();
    const auto velocity = [&](const Vec3& x) {
      Vec3 v;
      sampler->velocity(x, 0, v);
      return v;
    };
    for (std::size_t k = range.begin(); k < range.end(); ++k) {
      // Seeds of Roberts' additive recurrence.
      const auto at = [&](double ratio) {
        return 6.283 * (double(k) * ratio - std::floor(double(k) * ratio));
      };
      Vec3 x(at(0.8191725133961645), at(0.6710436067037893), at(0.5497004779019703));
      for (std::size_t i = 0; i <= segments; ++i) {
        set.positions[k * (segments + 1) + i] = x;
        const Vec3 a = velocity(x), b = velocity(x + step / 2 * a), c = velocity(x + step / 2 * b);
        x += step / 6 * (a + 2.0 * b + 2.0 * c + velocity(x + step * c));
      }
    }
  });
  return set;
}

scene::Scene lines_scene(scene::LineObject::Profile profile) {
  scene::Scene scene;
  scene.camera = abc_camera();
  scene.objects.push_back({"lines", scene::LineObject{abc_lines(), 0.004, profile}});
  return scene;
}

scene::Scene points_scene(scene::PointObject::Profile profile) {
  scene::Scene scene;
  scene.camera = {.eye = {1.9, 2.4, 3.4}, .target = {0, 0, 0}, .up = {0, 0, 1}, .fov = 36};
  auto points = std::get<geometry::PointSet>(scene::make_dataset("dark-sky"));
  points.colors.assign(points.positions.size(), Rgba(0.2, 0.4, 0.8, 0.05));
  scene.objects.push_back({"points", scene::PointObject{std::move(points), 0.003, profile}});
  return scene;
}

void build_and_render(benchmark::State& state, const auto& make_scene) {
  const scene::Scene scene = make_scene();
  const scene::MethodRow& row = groundtruth::raytrace_method();
  for (auto _ : state) {
    forget_peak_memory();
    const Stopwatch building;
    const auto renderer = row.make(scene, Parameters(row.name, row.parameters, {}), {});
    state.counters["build_s"] = building.seconds();
    const scene::Rendering rendering = renderer->render({.layers = true});
    state.counters["peak_GiB"] = peak_memory() / (1 << 30);
    state.counters["crossings"] = double(rendering.stats.fragments);
    state.counters["layers"] = rendering.stats.max_layers;
  }
}

void add(const char* name, const auto& make_scene) {
  benchmark::RegisterBenchmark(
      name, [make_scene](benchmark::State& state) { build_and_render(state, make_scene); })
      ->UseRealTime()
      ->Unit(benchmark::kSecond)
      ->Iterations(1);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  using Line = scene::LineObject::Profile;
  using Point = scene::PointObject::Profile;
  add("32000-lines-of-500/ribbons", [] { return lines_scene(Line::ribbon); });
  add("32000-lines-of-500/tubes", [] { return lines_scene(Line::tube); });
  add("16.3-million-points/discs", [] { return points_scene(Point::disc); });
  add("16.3-million-points/spheres", [] { return points_scene(Point::sphere); });
  benchmark::RunSpecifiedBenchmarks();
}
