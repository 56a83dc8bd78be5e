// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/run_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/report/budget_tables.h"
#include "compare/report/report.h"
#include "compare/report/tables.h"
#include "compare/run/study_jobs.h"
#include "core/error.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

/// So many cells are measured in turn, and have their memory at once.
constexpr std::size_t most_in_turn = 8;

class StudyRun {
 public:
  StudyRun(const Study& study, const StudyOptions& options)
      : study_(study), options_(options), jobs_(make_jobs(study, options)) {
    for (const Job& job : jobs_) job.files.make_folders();
    read_known_rows(jobs_, options);
    for (const Job& job : jobs_) outcome_.kept += job.row && job.selected;
  }

  StudyOutcome run() {
    calibrations_ = {options_.calibrate()};
    for (std::size_t first = 0; first < jobs_.size(); first += cells_per_scene())
      run_scene(std::span(jobs_).subspan(first, cells_per_scene()));
    finish();
    return std::move(outcome_);
  }

 private:
  std::size_t cells_per_scene() const { return 1 + study_.methods.size(); }

  void run_scene(std::span<Job> jobs) {
    const auto pending = [](const Job& job) { return job.selected && !job.row; };
    if (std::none_of(jobs.begin(), jobs.end(), pending)) return;
    Job& reference = jobs.front();
    SceneAtHand at_hand(jobs.back().cell.scene_file, study_, options_.context);
    SceneAtHand of_reference(reference.cell.scene_file, study_, options_.context);
    const bool one_scene = reference.cell.scene_file == jobs.back().cell.scene_file;
    if (!reference.row && !one_scene) run_batch({&reference}, reference, of_reference);
    at_hand.set_reference(reference.files);
    if (reference.row) at_hand.reads_also(reference.row->files_read);
    std::vector<Job*> open;
    for (Job& job : jobs)
      if (!job.row && (job.selected || &job == &reference)) open.push_back(&job);
    const std::size_t at_once = study_.timing ? most_in_turn : 1;
    for (std::size_t first = 0; first < open.size(); first += at_once)
      run_batch(
          {open.begin() + long(first), open.begin() + long(std::min(first + at_once, open.size()))},
          reference, at_hand);
  }

  /// Measures the cells in turn. Where their reference has failed, they do.
  void run_batch(const std::vector<Job*>& batch, const Job& reference, SceneAtHand& at_hand) {
    const auto lacks_reference = [&](const Job* job) {
      return job != &reference && reference.row && !reference.row->error.empty();
    };
    if (lacks_reference(batch.front())) return skip(batch);
    report(options_.progress, progress(), batch_name(batch));
    std::vector<Finding> findings = measure_views(batch, at_hand);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (lacks_reference(batch[i])) return skip({batch.begin() + long(i), batch.end()});
      ResultRow row = findings[i].error.empty() ? finished_row(*batch[i], findings[i].rows, at_hand)
                                                : failed_row(*batch[i], findings[i].error);
      row.calibrations = calibrations_;
      if (batch[i] == &reference) at_hand.reads_also(row.files_read);
      record(*batch[i], std::move(row));
    }
  }

  /// What was found of a cell from the views until now, or why it failed: an adverse cell must not
  /// take the others with it.
  struct Finding {
    ViewRows rows;
    std::string error = {};
  };

  /// From each view in turn all cells are measured that have not failed.
  std::vector<Finding> measure_views(const std::vector<Job*>& batch, SceneAtHand& at_hand) {
    calibrations_ = {calibrations_.back()};  // what ended the last cells begins these
    std::vector<Finding> findings(batch.size(), Finding{ViewRows(study_.views.path)});
    try {
      const std::size_t views = at_hand.view_count();
      for (std::size_t view = 0; view < views; ++view) {
        at_hand.look_from(view);
        const std::string place = views > 1 ? fmt::format("view {}: ", view + 1) : "";
        measure_view(batch, at_hand, place, findings);
      }
    } catch (const std::exception& error) {  // the scene cannot be loaded
      for (Finding& finding : findings)
        if (finding.error.empty()) finding.error = one_line(error.what());
    }
    calibrations_.push_back(options_.calibrate());
    return findings;
  }

  void measure_view(const std::vector<Job*>& batch, SceneAtHand& at_hand, const std::string& place,
                    std::vector<Finding>& findings) {
    std::vector<Cell> cells;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (!findings[i].error.empty()) continue;
      places.push_back(i);
      cells.push_back(batch[i]->cell);
      cells.back().place = {batch[i]->files.from(at_hand.view()).given(), int(at_hand.view()) + 1};
      if (at_hand.view() > 0) cells.back().probes.clear();  // pixels of the first view
    }
    std::vector<MeasuredCell> measured =
        measure_interleaved(cells, at_hand.scene(), timing_of(study_), options_.context,
                            [&] { calibrate_in_turn(cells.size()); });
    for (std::size_t k = 0; k < places.size(); ++k)
      finish_one(*batch[places[k]], std::move(measured[k]), at_hand, place, findings[places[k]]);
  }

  void finish_one(const Job& job, MeasuredCell measured, SceneAtHand& at_hand,
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

  static std::string batch_name(const std::vector<Job*>& batch) {
    const std::string first = batch.front()->cell.name();
    return batch.size() == 1 ? first : fmt::format("{} and {} more", first, batch.size() - 1);
  }

  /// Of one cell alone the loops before and after it are enough.
  void calibrate_in_turn(std::size_t cells) {
    if (cells > 1) calibrations_.push_back(options_.calibrate());
  }

  void skip(const std::vector<Job*>& jobs) {
    for (Job* job : jobs) record(*job, failed_row(*job, "its scene's reference failed"));
  }

  /// Where no row can be written, on a full disk, the study ends.
  void record(Job& job, ResultRow row) {
    row.machine["build"] = options_.build;
    row.machine["gl"] = options_.context.gl;
    write_row(job.files, row);
    job.row = std::move(row);
    ++outcome_.computed;
    write_text(options_.folder / "results.csv", csv_table(known_rows()));
    if (options_.on_row) options_.on_row(*job.row);
  }

  double progress() const {
    const auto done =
        std::count_if(jobs_.begin(), jobs_.end(), [](const Job& j) { return !!j.row; });
    return double(done) / double(jobs_.size());
  }

  std::vector<ResultRow> known_rows() const {
    std::vector<ResultRow> rows;
    for (const Job& job : jobs_)
      if (job.row) rows.push_back(*job.row);
    return rows;
  }

  void finish() {
    report(options_.progress, 1, "report");
    outcome_.rows = known_rows();
    write_text(options_.folder / "results.csv", csv_table(outcome_.rows));
    write_text(options_.folder / "results.json", results_json(study_, outcome_.rows));
    write_text(options_.folder / "table.md", markdown_table(study_, outcome_.rows));
    write_text(options_.folder / "table.tex", latex_table(study_, outcome_.rows));
    if (study_.budget) write_text(options_.folder / "budget.csv", csv_budgets(outcome_.rows));
    if (study_.published)
      write_text(options_.folder / "costs.csv", csv_costs(study_, outcome_.rows));
    write_report(options_.folder, study_, outcome_.rows, options_.report);
  }

  const Study& study_;
  const StudyOptions& options_;
  std::vector<Job> jobs_;
  StudyOutcome outcome_;
  std::vector<Calibration> calibrations_;  // from the last cells' end on
};

}  // namespace

StudyOutcome run_study(const Study& study, const StudyOptions& options) {
  return StudyRun(study, options).run();
}

}  // namespace pellucid::compare
