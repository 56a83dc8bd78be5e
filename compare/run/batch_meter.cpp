// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/batch_meter.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::compare {

BatchMeter::BatchMeter(const Study& study, const StudyOptions& options)
    : study_(study), options_(options), calibrations_{options.calibrate()} {}

std::vector<Finding> BatchMeter::measure(const std::vector<Job*>& batch, SceneAtHand& at_hand) {
  calibrations_ = {calibrations_.back()};  // what ended the last cells begins these
  std::vector<Finding> findings(batch.size(), Finding{ViewRows(study_.views.path)});
  try {
    const std::size_t views = at_hand.view_count();
    for (std::size_t view = 0; view < views; ++view) {
      at_hand.look_from(view);
      const std::string place = views > 1 ? fmt::format("view {}: ", view + 1) : "";
      measure_view(batch, at_hand, place, findings);
      for (Finding& finding : findings) finding.memory.next_frame();
    }
  } catch (const std::exception& error) {  // the scene cannot be loaded
    for (Finding& finding : findings)
      if (finding.error.empty()) finding.error = one_line(error.what());
  }
  calibrations_.push_back(options_.calibrate());
  return findings;
}

ResultRow BatchMeter::row_of(const Job& job, const Finding& finding, SceneAtHand& at_hand) const {
  ResultRow row = finding.error.empty() ? finished_row(job, finding.rows, at_hand)
                                        : failed_row(job, finding.error);
  row.calibrations = calibrations_;
  return row;
}

void BatchMeter::measure_view(const std::vector<Job*>& batch, SceneAtHand& at_hand,
                              const std::string& place, std::vector<Finding>& findings) {
  std::vector<Cell> cells;
  std::vector<std::size_t> places;
  std::vector<scene::RenderContext> contexts;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!findings[i].error.empty()) continue;
    places.push_back(i);
    contexts.push_back(options_.context);
    if (study_.views.path) contexts.back().memory = &findings[i].memory;
    cells.push_back(batch[i]->cell);
    cells.back().place = {batch[i]->files.from(at_hand.view()).given(), int(at_hand.view()) + 1};
    if (at_hand.view() > 0) cells.back().probes.clear();  // pixels of the first view
  }
  std::vector<MeasuredCell> measured =
      measure_interleaved(cells, at_hand.scene(), timing_of(study_), contexts,
                          [&] { calibrate_in_turn(cells.size()); });
  for (std::size_t k = 0; k < places.size(); ++k)
    finish_one(*batch[places[k]], std::move(measured[k]), at_hand, place, findings[places[k]]);
}

void BatchMeter::finish_one(const Job& job, MeasuredCell measured, SceneAtHand& at_hand,
                            const std::string& place, Finding& finding) {
  if (!measured.measurement) {
    finding.error = place + measured.error;
    return;
  }
  try {
    finish_view(job, std::move(*measured.measurement), at_hand, study_, finding.rows);
  } catch (const std::exception& error) {
    finding.error = place + one_line(error.what());
  }
}

/// Of one cell alone the loops before and after it are enough.
void BatchMeter::calibrate_in_turn(std::size_t cells) {
  if (cells > 1) calibrations_.push_back(options_.calibrate());
}

}  // namespace pellucid::compare
