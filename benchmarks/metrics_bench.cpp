// SPDX-License-Identifier: GPL-3.0-or-later
// Image metrics on 1000×1000 RGB. `scripts/make-metric-expectations.py --time` times scikit-image's
// SSIM of the same pictures on the same machine.
#include <benchmark/benchmark.h>

#include "compare/pictures/metrics.h"

namespace {

using namespace pellucid;

Image waves(int size, int period) {
  Image image(size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      image.at(x, y) = Rgba(float(x * y % period) / float(period), float(x % 256) / 255.f,
                            float(y % 256) / 255.f, 1.f);
  return image;
}

template <auto Metric>
void time_metric(benchmark::State& state) {
  const Image x = waves(int(state.range(0)), 251), y = waves(int(state.range(0)), 241);
  for (auto _ : state) benchmark::DoNotOptimize(Metric(x, y));
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(0));
}

}  // namespace

BENCHMARK(time_metric<compare::ssim>)
    ->Name("ssim")
    ->Arg(1000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(time_metric<compare::rmse>)
    ->Name("rmse")
    ->Arg(1000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(time_metric<compare::compare_images>)
    ->Name("compare")
    ->Arg(1000)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
