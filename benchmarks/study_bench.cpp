// SPDX-License-Identifier: GPL-3.0-or-later
// What share of a study's wall clock goes into measuring: bench_study [STUDY], by default
// quickstart.
//
// A study's time is that of the methods (setting up, the first picture, the timed ones), of loading
// the scenes, of tables and report, and the rest: counting layers, comparing, encoding and writing
// pictures. The methods' own time is what the rows say of it, loading is timed apart from the
// study.
#include <benchmark/benchmark.h>

#include <filesystem>

#include "compare/methods/methods.h"
#include "compare/results/measure_columns.h"
#include "compare/run/run_study.h"
#include "core/machine/stopwatch.h"
#include "scene/files/scene_file.h"

namespace {

using namespace pellucid;
namespace fs = std::filesystem;

double own_seconds(const compare::ResultRow& row) {
  const double views = compare::measure_of(row, "views").value_or(1);
  return views * (row.first_frame_seconds() + row.repeats * row.seconds.median);
}

double seconds_to_load(const compare::Study& study) {
  const Stopwatch watch;
  for (const fs::path& file : study.scenes) benchmark::DoNotOptimize(scene::load_scene(file));
  return watch.seconds();
}

void run_and_account(benchmark::State& state, const compare::Study& study) {
  compare::StudyOptions options;
  options.folder = fs::temp_directory_path() / "pellucid-bench-study";
  double own = 0, cells = 0;
  const Stopwatch watch;
  options.on_row = [&](const compare::ResultRow& row) {
    own += own_seconds(row);
    cells = watch.seconds();
  };
  for (auto _ : state) compare::run_study(study, options);
  const double wall = watch.seconds();
  const double loading = seconds_to_load(study);
  fs::remove_all(options.folder);
  state.counters["wall_s"] = wall;
  state.counters["methods_s"] = own;
  state.counters["loading_s"] = loading;
  state.counters["report_s"] = wall - cells;
  state.counters["measuring_s"] = cells - own - loading;
  state.counters["measuring_percent"] = 100 * (cells - own - loading) / wall;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const compare::Study study = compare::load_study(
      compare::find_study(argc > 1 ? argv[1] : "quickstart"), compare::methods());
  benchmark::RegisterBenchmark(study.name.c_str(),
                               [&](benchmark::State& state) { run_and_account(state, study); })
      ->Iterations(1)
      ->UseRealTime()
      ->Unit(benchmark::kSecond);
  benchmark::RunSpecifiedBenchmarks();
}
