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

/// Steps have the same names in the same order in every repeat.
std::vector<std::pair<std::string, Spread>> step_spreads(
    const std::vector<scene::RenderStats>& runs, const TimingRule& timing) {
  std::vector<std::pair<std::string, Spread>> steps;
  for (std::size_t i = 0; i < runs.front().steps.size(); ++i) {
    std::vector<double> seconds;
    for (const scene::RenderStats& run : runs)
      if (i < run.steps.size()) seconds.push_back(run.steps[i].seconds);
    steps.emplace_back(runs.front().steps[i].name, spread_of(seconds, timing));
  }
  return steps;
}

std::optional<double> median_by_gl(const std::vector<scene::RenderStats>& runs) {
  std::vector<double> seconds;
  for (const scene::RenderStats& run : runs)
    if (const auto by_gl = run.gl_seconds()) seconds.push_back(*by_gl);
  return seconds.empty() ? std::nullopt : std::optional(median_of(std::move(seconds)));
}

void describe(const scene::Renderer& renderer, const scene::Scene& scene, ResultRow& row) {
  row.explanation = renderer.explain();
  row.scene_provenance = scene.provenance;
  row.machine = machine_facts();
  row.machine.merge(renderer.facts());
}

void take_findings(scene::Findings findings, CellMeasurement& result) {
  result.row.measures = std::move(findings.measures);
  for (scene::MeasurePicture& picture : findings.pictures) {
    result.row.pictures.push_back({picture.name, picture.title, picture.min, picture.max});
    result.further.push_back(std::move(picture.image));
  }
}

}  // namespace

CellMeter::CellMeter(const Cell& cell, const scene::Scene& scene,
                     const scene::RenderContext& context, bool first_is_timed)
    : cell_(cell), scene_(scene), result_{identity_row(cell), {}, {}, {}, {}} {
  const Stopwatch setup;
  renderer_ = make_renderer(cell.call, scene, context, cell.place);
  result_.row.setup_seconds = setup.seconds();
  warm_up(first_is_timed);
}

// Counting takes time, which is in no step: this picture's steps are those of a first frame.
void CellMeter::warm_up(bool is_timed) {
  scene::RenderRequest counting;
  counting.layers = true;
  scene::Rendering rendering = renderer_->render(counting);
  result_.layers = std::move(rendering.layers);
  result_.row.first_seconds = rendering.stats.seconds();
  result_.row.fragments = rendering.stats.fragments;
  result_.row.max_layers = rendering.stats.max_layers;
  result_.row.stored = rendering.stats.stored;
  result_.row.dropped = rendering.stats.dropped;
  result_.row.truncated = rendering.stats.truncated;
  result_.row.bytes = rendering.stats.bytes;
  if (is_timed) keep(std::move(rendering));
}

void CellMeter::time_once() { keep(renderer_->render({.draw = std::uint32_t(runs_.size())})); }

void CellMeter::keep(scene::Rendering rendering) {
  const auto draw = std::uint32_t(runs_.size());
  runs_.push_back(std::move(rendering.stats));
  seconds_.push_back(runs_.back().seconds());
  if (draw == 0)
    result_.image = std::move(rendering.image);
  else if (cell_.call.row->promises.random && draw < judged_draws)
    result_.draws.push_back(std::move(rendering.image));
}

const std::vector<Image>& CellMeter::draws() {
  if (!cell_.call.row->promises.random) return result_.draws;
  while (result_.draws.size() + 1 < judged_draws)
    result_.draws.push_back(
        renderer_->render({.draw = std::uint32_t(result_.draws.size() + 1)}).image);
  return result_.draws;
}

CellMeasurement CellMeter::finish(const TimingRule& timing) {
  require_finite(result_.image, cell_.call.text());
  ResultRow& row = result_.row;
  row.repeats = int(runs_.size());
  row.seconds = spread_of(seconds_, timing);
  if (cell_.call.given) {  // others are the same picture again
    row.repeats = runs_.back().steps.empty() ? 0 : 1;
    row.seconds.interval.reset();
  }
  row.steps = step_spreads(runs_, timing);
  row.gl_seconds = median_by_gl(runs_);
  row.bytes = runs_.back().bytes;
  if (timing.relative) row.settled = is_settled(seconds_, timing);
  describe(*renderer_, scene_, row);
  take_findings(renderer_->findings(), result_);
  add_ray_curves(cell_, scene_, *renderer_, result_);
  draws();
  return std::move(result_);
}

bool is_drawn_once(const Cell& cell, const TimingRule& timing) {
  return timing.max == 1 && cell.call.row->promises.in_double;
}

CellMeasurement measure_cell(const Cell& cell, const scene::Scene& scene, const TimingRule& timing,
                             const scene::RenderContext& context) {
  CellMeter meter(cell, scene, context, is_drawn_once(cell, timing));
  while (!is_over(meter.seconds(), timing)) meter.time_once();
  return meter.finish(timing);
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
