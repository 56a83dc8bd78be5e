// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of docs/isosurface.md, each a pair measured in turn in one run:
//
// - picture/...: `raytrace` against `march:step=16` on the big field, 7.1 million samples, with the
//   RMSE of the march; each once, loading and indexing apart.
// - sample/...: one trilinear sample of a field on levels, and of a velocity grid, against
//   OpenVDB's BoxSampler on one reused accessor at the same places.
// - scalar/q: the Q-criterion of the big field's finest level against the barest scalar, the sum of
//   the three components: what reading and writing alone take on the same threads.
// - memory/...: what a loaded and indexed field keeps, and the peak on the way, against its grids
//   as OpenVDB keeps them; both as the process's resident pages.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <malloc.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Interpolation.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "compare/pictures/metrics.h"
#include "core/files/output_file.h"
#include "core/machine/stopwatch.h"
#include "core/parallel.h"
#include "fields/levels/derived_scalar.h"
#include "fields/levels/level_field.h"
#include "fields/levels/level_files.h"
#include "fields/levels/vdb_levels.h"
#include "fields/make_field.h"
#include "groundtruth/methods/march.h"
#include "groundtruth/methods/raytrace.h"
#include "groundtruth/traversal/crossing_finder.h"
#include "scene/datasets/dataset.h"
#include "scene/files/scene_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid {
namespace {

constexpr const char* big_field = "sphere-levels:size=big,rings=5";

// Pictures

scene::Rendering drawn(const scene::MethodRow& row, const scene::Scene& scene,
                       const RawOptions& options, double& seconds) {
  const Stopwatch watch;
  const auto renderer = row.make(scene, Parameters(row.name, row.parameters, options), {});
  scene::Rendering rendering = renderer->render({});
  seconds = watch.seconds();
  return rendering;
}

void exact_against_marched(benchmark::State& state, const std::string& scene_file) {
  const Stopwatch loading;
  const scene::Scene scene = scene::load_scene(scene_file);
  state.counters["load_s"] = loading.seconds();
  for (auto _ : state) {
    double exact_s = 0, march_s = 0;
    const scene::Rendering exact = drawn(groundtruth::raytrace_method(), scene, {}, exact_s);
    const scene::Rendering marched =
        drawn(groundtruth::march_method(), scene, {{"step", "16"}}, march_s);
    state.SetIterationTime(exact_s);
    state.counters["march_s"] = march_s;
    state.counters["march/exact"] = march_s / exact_s;
    state.counters["rmse"] = compare::rmse(exact.image, marched.image);
    state.counters["crossings"] = double(exact.stats.fragments);
    state.counters["marched_crossings"] = double(marched.stats.fragments);
  }
}

// Samples

/// Steps of a sixteenth of the finest cell along lines through the level.
std::vector<Vec3> places(const Box3& box, double step) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> fraction(0.1, 0.9);
  const auto any = [&] {
    return box.min +
           (box.max - box.min) * Vec3(fraction(random), fraction(random), fraction(random));
  };
  std::vector<Vec3> points;
  while (points.size() < 1 << 14) {
    const Vec3 from = any(), to = any();
    const Vec3 direction = glm::normalize(to - from);
    for (int i = 0; i < 64; ++i) points.push_back(from + step * i * direction);
  }
  points.resize(1 << 14);
  return points;
}

double nanoseconds_of(const std::vector<Vec3>& points, const auto& sample) {
  const Stopwatch watch;
  for (const Vec3& x : points) benchmark::DoNotOptimize(sample(x));
  return 1e9 * watch.seconds() / double(points.size());
}

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + values.size() / 2);
  return values[values.size() / 2];
}

/// Times `ours` and `bare`, which return nanoseconds per item, in turn.
void in_pairs(benchmark::State& state, const auto& ours, const auto& bare) {
  ours(), bare();  // warm-up
  std::vector<double> ratios, ours_ns, bare_ns;
  for (auto _ : state) {
    ours_ns.push_back(ours());
    bare_ns.push_back(bare());
    ratios.push_back(ours_ns.back() / bare_ns.back());
    state.SetIterationTime(1e-9 * ours_ns.back());
  }
  state.counters["ratio"] = median(ratios);
  state.counters["ns"] = median(ours_ns);
  state.counters["bare_ns"] = median(bare_ns);
}

void in_pairs(benchmark::State& state, const std::vector<Vec3>& points, const auto& ours,
              const auto& bare) {
  in_pairs(
      state, [&] { return nanoseconds_of(points, ours); },
      [&] { return nanoseconds_of(points, bare); });
}

template <class Grid>
typename Grid::Ptr read_finest(const std::filesystem::path& path) {
  openvdb::io::File file(path.string());
  file.open(false);
  typename Grid::Ptr finest;
  for (auto name = file.beginName(); name != file.endName(); ++name) {
    const auto grid = openvdb::gridPtrCast<Grid>(file.readGrid(*name));
    if (!finest || grid->voxelSize()[0] < finest->voxelSize()[0]) finest = grid;
  }
  return finest;
}

template <class Grid>
auto bare_sampler(const Grid& grid) {
  return [&grid, accessor = grid.getConstAccessor()](const Vec3& x) {
    typename Grid::ValueType value;
    openvdb::tools::BoxSampler::sample(accessor, grid.transform().worldToIndex({x.x, x.y, x.z}),
                                       value);
    return value;
  };
}

void sample_levels(benchmark::State& state, const std::filesystem::path& file,
                   std::string_view reconstruction, bool finest_alone) {
  std::vector<fields::ScalarLevel> levels = std::get<0>(fields::read_levels(file, "q").levels);
  if (finest_alone) {
    std::ranges::sort(levels, {}, &fields::ScalarLevel::width);
    levels.resize(1);
  }
  const fields::LevelField field(std::move(levels), fields::find_reconstruction(reconstruction));
  const auto grid = read_finest<openvdb::FloatGrid>(file);
  in_pairs(
      state, places(field.levels().front().box(-2), field.levels().front().width / 16),
      [&](const Vec3& x) { return field.value(x); }, bare_sampler(*grid));
}

/// A voxel away from the box makes the reader keep the tree.
void sample_velocity(benchmark::State& state, const testing::TemporaryFolder& folder,
                     const std::filesystem::path& file) {
  const auto grid = read_finest<openvdb::Vec3SGrid>(file);
  const openvdb::Vec3d first = grid->indexToWorld(openvdb::Coord(2, 2, 2)),
                       last = grid->indexToWorld(grid->evalActiveVoxelBoundingBox().max());
  grid->setName("velocity");
  grid->getAccessor().setValueOn({-1000, 0, 0});
  const auto path = folder / "sparse.vdb";
  openvdb::io::File(path.string()).write({grid});
  const auto field = fields::make_field(path.string());
  const auto sampler = field->sampler();
  in_pairs(
      state,
      places({{first[0], first[1], first[2]}, {last[0], last[1], last[2]}},
             grid->voxelSize()[0] / 16),
      [&](const Vec3& x) {
        Vec3 v;
        sampler->velocity(x, 0, v);
        return v;
      },
      bare_sampler(*grid));
}

// Derived scalars

fields::ScalarLevel sum_of_components(const fields::VectorLevel& v) {
  fields::ScalarLevel out{v.origin, v.width, v.size, std::vector<float>(v.samples.size())};
  parallel_for(0, v.size[2], [&](int k) {
    for (std::size_t i = v.index(0, 0, k); i < v.index(0, 0, k + 1); ++i)
      out.samples[i] = v.samples[i].x + v.samples[i].y + v.samples[i].z;
  });
  return out;
}

void derive(benchmark::State& state) {
  const fields::VectorLevel level = scene::make_velocity_levels(big_field).back();
  const auto time = [&](const auto& compute) {
    const Stopwatch watch;
    benchmark::DoNotOptimize(compute(level).samples.data());
    return 1e9 * watch.seconds() / double(level.samples.size());
  };
  in_pairs(
      state, [&] { return time(fields::find_derived_scalar("q").compute); },
      [&] { return time(sum_of_components); });
}

// Memory

/// A line "NAME: N kB" of the process's status, in bytes.
double status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(name + ":")) return 1024 * std::stod(line.substr(name.size() + 1));
  return 0;
}

/// Gives back what is free, and forgets the peak so far.
double resident_now() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  return status("VmRSS");
}

struct Growth {
  double kept, peak;  // bytes
};

template <class Make>
Growth growth_of(const Make& make) {
  const double before = resident_now();
  const auto made = make();
  const double peak = status("VmHWM") - before;
  return {resident_now() - before, peak};
}

std::vector<openvdb::GridBase::Ptr> read_grids(const std::filesystem::path& path) {
  std::vector<openvdb::GridBase::Ptr> grids;
  openvdb::io::File file(path.string());
  file.open(false);
  for (auto name = file.beginName(); name != file.endName(); ++name)
    grids.push_back(file.readGrid(*name));
  return grids;
}

/// The scene and the hierarchy over its crossings.
struct Indexed {
  std::unique_ptr<const scene::Scene> scene;
  std::unique_ptr<groundtruth::CrossingFinder> finder;
};

void memory(benchmark::State& state, const std::filesystem::path& scene_file,
            const std::filesystem::path& grid_file) {
  for (auto _ : state) {
    const Growth grids = growth_of([&] { return read_grids(grid_file); });
    const Stopwatch watch;
    const Growth field = growth_of([&] {
      Indexed indexed{std::make_unique<const scene::Scene>(scene::load_scene(scene_file)), nullptr};
      indexed.finder = std::make_unique<groundtruth::CrossingFinder>(*indexed.scene,
                                                                     groundtruth::Precision::exact);
      return indexed;
    });
    state.SetIterationTime(watch.seconds());
    state.counters["grids_MB"] = 1e-6 * grids.kept;
    state.counters["field_MB"] = 1e-6 * field.kept;
    state.counters["peak_MB"] = 1e-6 * field.peak;
    state.counters["field/grids"] = field.kept / grids.kept;
    state.counters["peak/grids"] = field.peak / grids.kept;
  }
}

/// A scene of the file's isosurface.
std::filesystem::path write_scene(const testing::TemporaryFolder& folder, const std::string& grids,
                                  const std::string& look) {
  const auto path = folder / (grids + (look.empty() ? "" : "-colored") + ".json");
  write_text(path, R"({"format": "pellucid-scene", "version": 1, "objects": [{"isosurface":
      {"file": ")" + grids +
                       R"(.vdb", "scalar": "q", "value": 0.02})" + look + "}]}");
  return path;
}

void once(const std::string& name, benchmark::TimeUnit unit, int iterations, auto run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Unit(unit)
      ->Iterations(iterations);
}

void add_samples(const testing::TemporaryFolder& folder, const std::filesystem::path& velocity,
                 const std::filesystem::path& scalar) {
  for (const fields::ReconstructionRow& row : fields::reconstructions)
    for (const bool alone : {true, false})
      once(fmt::format("sample/{}/{}", row.name, alone ? "finest-level" : "four-levels"),
           benchmark::kNanosecond, 25,
           [=](benchmark::State& state) { sample_levels(state, scalar, row.name, alone); });
  once("sample/velocity", benchmark::kNanosecond, 25,
       [=, &folder](benchmark::State& state) { sample_velocity(state, folder, velocity); });
}

}  // namespace
}  // namespace pellucid

/// A folder with the scenes may follow the options; "scenes/isosurface" is its default.
int main(int argc, char** argv) {
  using namespace pellucid;
  benchmark::Initialize(&argc, argv);
  const std::filesystem::path scenes = argc > 1 ? argv[1] : "scenes/isosurface";
  const testing::TemporaryFolder folder;
  const auto velocity = folder / "velocity.vdb", scalar = folder / "scalar.vdb";
  {
    const std::vector<fields::VectorLevel> levels = scene::make_velocity_levels(big_field);
    fields::write_vdb_levels(velocity, "velocity", levels);
    fields::write_vdb_levels(scalar, "q", fields::scalars_of(levels, "q"));
  }
  for (const auto& [name, look] :
       {std::pair("memory/", ""), std::pair("memory/colored/", R"(, "color": {"by": "speed"})")})
    once(std::string(name) + "velocity-grids", benchmark::kSecond, 1,
         [scene = write_scene(folder, "velocity", look), velocity](benchmark::State& state) {
           memory(state, scene, velocity);
         });
  once("memory/scalar-grids", benchmark::kSecond, 1,
       [scene = write_scene(folder, "scalar", ""), scalar](benchmark::State& state) {
         memory(state, scene, scalar);
       });
  add_samples(folder, velocity, scalar);
  once("scalar/q", benchmark::kNanosecond, 15, derive);
  for (const std::string name :
       {"multi-big-1080p-filtered", "multi-big-4k-filtered", "transparent-4k"})
    once("picture/" + name, benchmark::kSecond, 1, [=](benchmark::State& state) {
      exact_against_marched(state, (scenes / (name + ".json")).string());
    });
  benchmark::RunSpecifiedBenchmarks();
}
