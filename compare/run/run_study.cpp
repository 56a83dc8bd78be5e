// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/run_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compare/report/results_folder.h"
#include "compare/report/tables.h"
#include "compare/run/batch_meter.h"
#include "compare/run/study_screen.h"
#include "core/files/output_file.h"

namespace pellucid::compare {
namespace {

/// So many cells are measured in turn, and have their memory at once.
constexpr std::size_t most_in_turn = 8;

class StudyRun {
 public:
  StudyRun(const Study& study, const StudyOptions& options)
      : study_(study),
        options_(options),
        jobs_(make_jobs(study, options)),
        meter_(study, options),
        screen_(study, options) {
    for (const Job& job : jobs_) job.files.make_folders();
    read_known_rows(jobs_, options);
    for (const Job& job : jobs_) outcome_.kept += job.row && job.selected;
  }

  StudyOutcome run() {
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
    const std::set<std::string> screened = screen_.left_out(jobs, at_hand, progress());
    for (Job& job : jobs)
      if (!job.row && (job.selected || &job == &reference) && !screened.contains(job.cell.name()))
        open.push_back(&job);
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
    const std::vector<Finding> findings = meter_.measure(batch, at_hand);
    for (std::size_t i = 0; i < batch.size(); ++i) {
      if (lacks_reference(batch[i])) return skip({batch.begin() + long(i), batch.end()});
      ResultRow row = meter_.row_of(*batch[i], findings[i], at_hand);
      if (batch[i] == &reference) at_hand.reads_also(row.files_read);
      record(*batch[i], std::move(row));
    }
  }

  static std::string batch_name(const std::vector<Job*>& batch) {
    const std::string first = batch.front()->cell.name();
    return batch.size() == 1 ? first : fmt::format("{} and {} more", first, batch.size() - 1);
  }

  void skip(const std::vector<Job*>& jobs) {
    for (Job* job : jobs) record(*job, failed_row(*job, reference_failed));
  }

  /// Where no row can be written, on a full disk, the study ends.
  void record(Job& job, ResultRow row) {
    finish_job(job, std::move(row), options_);
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
    const Study told = screen_.tell(jobs_, cells_per_scene());
    write_results(options_.folder, told, outcome_.rows, options_.report);
  }

  const Study& study_;
  const StudyOptions& options_;
  std::vector<Job> jobs_;
  StudyOutcome outcome_;
  BatchMeter meter_;
  StudyScreen screen_;
};

}  // namespace

StudyOutcome run_study(const Study& study, const StudyOptions& options) {
  return StudyRun(study, options).run();
}

}  // namespace pellucid::compare
