// SPDX-License-Identifier: GPL-3.0-or-later
// Image metrics on 1000×1000 RGB, those that look at more than single pixels also on 1920×1080.
// `scripts/make-metric-expectations.py --time` times scikit-image's SSIM of the same pictures on
// the same machine.
#include <benchmark/benchmark.h>

#include "compare/pictures/metrics.h"

namespace {

using namespace pellucid;

Image waves(int width, int height, int period) {
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.at(x, y) = Rgba(float(x * y % period) / float(period), float(x % 256) / 255.f,
                            float(y % 256) / 255.f, 1.f);
  return image;
}

compare::Comparison compare_all(const Image& x, const Image& y) {
  return compare::compare_images(x, y);
}

/// Of width × height pixels.
template <auto Metric>
void time_metric(benchmark::State& state) {
  const int width = int(state.range(0)), height = int(state.range(1));
  const Image x = waves(width, height, 251), y = waves(width, height, 241);
  for (auto _ : state) benchmark::DoNotOptimize(Metric(x, y));
  state.SetItemsProcessed(state.iterations() * state.range(0) * state.range(1));
}

template <auto Metric>
void add(const char* name, int width, int height) {
  benchmark::RegisterBenchmark(name, time_metric<Metric>)
      ->Args({width, height})
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  add<compare::ssim>("ssim", 1000, 1000);
  add<compare::rmse>("rmse", 1000, 1000);
  add<compare_all>("compare", 1000, 1000);
  add<compare::flip>("flip", 1920, 1080);
  add<compare::ms_ssim>("ms_ssim", 1920, 1080);
  add<compare::ssim>("ssim", 1920, 1080);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
