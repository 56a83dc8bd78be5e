// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/measure_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "compare/cells/ray_curves.h"
#include "core/error.h"
#include "core/machine/machine.h"
#include "core/machine/stopwatch.h"

namespace pellucid::compare {
namespace {

Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {(values[(n - 1) / 2] + values[n / 2]) / 2, values.front(), values.back()};
}

/// Steps have the same names in the same order in every repeat.
std::vector<std::pair<std::string, Spread>> step_spreads(
    const std::vector<scene::RenderStats>& runs) {
  std::vector<std::pair<std::string, Spread>> steps;
  for (std::size_t i = 0; i < runs.front().steps.size(); ++i) {
    std::vector<double> seconds;
    for (const scene::RenderStats& run : runs)
      if (i < run.steps.size()) seconds.push_back(run.steps[i].seconds);
    steps.emplace_back(runs.front().steps[i].name, spread(seconds));
  }
  return steps;
}

Spread total_spread(const std::vector<scene::RenderStats>& runs) {
  std::vector<double> seconds;
  seconds.reserve(runs.size());
  for (const scene::RenderStats& run : runs) seconds.push_back(run.seconds());
  return spread(seconds);
}

void describe(const scene::Renderer& renderer, const scene::Scene& scene, ResultRow& row) {
  row.explanation = renderer.explain();
  row.scene_provenance = scene.provenance;
  row.machine = machine_facts();
  row.machine.merge(renderer.facts());
}

void check_finite(const Image& image) {
  const std::size_t bad = count_not_finite(image);
  if (bad > 0) throw WorkError(fmt::format("{} pixels of its picture are not finite", bad));
}

/// Counting takes time, so that the rendering that warms up counts and the timed ones don't.
void warm_up(scene::Renderer& renderer, CellMeasurement& result) {
  scene::RenderRequest counting;
  counting.layers = true;
  scene::Rendering rendering = renderer.render(counting);
  result.layers = std::move(rendering.layers);
  result.row.fragments = rendering.stats.fragments;
  result.row.max_layers = rendering.stats.max_layers;
  result.row.stored = rendering.stats.stored;
  result.row.dropped = rendering.stats.dropped;
  result.row.truncated = rendering.stats.truncated;
}

void time_renderings(scene::Renderer& renderer, int repeats, CellMeasurement& result) {
  std::vector<scene::RenderStats> runs;
  for (int i = 0; i < repeats; ++i) {
    scene::Rendering rendering = renderer.render({});
    runs.push_back(std::move(rendering.stats));
    result.image = std::move(rendering.image);
  }
  check_finite(result.image);
  result.row.repeats = repeats;
  result.row.seconds = total_spread(runs);
  result.row.steps = step_spreads(runs);
  result.row.bytes = runs.back().bytes;
}

void take_findings(scene::Findings findings, CellMeasurement& result) {
  result.row.measures = std::move(findings.measures);
  for (scene::MeasurePicture& picture : findings.pictures) {
    result.row.pictures.push_back({picture.name, picture.title, picture.min, picture.max});
    result.further.push_back(std::move(picture.image));
  }
}

}  // namespace

CellMeasurement measure_cell(const Cell& cell, const scene::Scene& scene, int repeats,
                             const scene::RenderContext& context) {
  CellMeasurement result{identity_row(cell), {}, {}, {}};
  const Stopwatch setup;
  const auto renderer = make_renderer(cell.call, scene, context, cell.place);
  result.row.setup_seconds = setup.seconds();
  warm_up(*renderer, result);
  time_renderings(*renderer, repeats, result);
  describe(*renderer, scene, result.row);
  take_findings(renderer->findings(), result);
  add_ray_curves(cell, scene, *renderer, result);
  if (cell.call.given) result.row.repeats = 1;  // others are the same picture again
  return result;
}

CoverageCheck check_coverage(const Image& reference, const CountImage& reference_layers,
                             const Image& test, const CountImage& test_layers) {
  assert(reference.pixels.size() == test.pixels.size());
  assert(reference_layers.pixels.size() == test_layers.pixels.size());
  CoverageCheck check;
  check.pixels = test.pixels.size();
  double squares = 0;
  for (std::size_t i = 0; i < test.pixels.size(); ++i) {
    const std::int64_t more = std::int64_t(test_layers.pixels[i]) - reference_layers.pixels[i];
    if (more != 0) {
      ++check.differing;
      check.differing_by_more += std::abs(more) > 1;
      continue;
    }
    for (int c = 0; c < 3; ++c) {
      const double d = double(test.pixels[i][c]) - reference.pixels[i][c];
      squares += d * d;
    }
  }
  const double equal = double(check.pixels - check.differing);
  if (equal > 0) check.rmse_elsewhere = std::sqrt(squares / (3 * equal));
  return check;
}

}  // namespace pellucid::compare
