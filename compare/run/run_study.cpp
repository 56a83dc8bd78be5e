// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/run_study.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <memory>

#include "compare/cells/cell.h"
#include "compare/cells/measure_cell.h"
#include "compare/measures/layer_error.h"
#include "compare/measures/layer_pictures.h"
#include "compare/measures/study_measures.h"
#include "compare/methods/optimize_opacities.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/flip.h"
#include "compare/pictures/given_faults.h"
#include "compare/pictures/image_file.h"
#include "compare/report/report.h"
#include "compare/report/tables.h"
#include "core/error.h"
#include "core/files/output_file.h"
#include "core/options/names.h"
#include "scene/files/scene_file.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// A cell of this run, and its row once there is one.
struct Job {
  Cell cell;
  CellFiles files;
  std::string fingerprint;
  bool selected = true;
  std::optional<ResultRow> row = std::nullopt;
};

bool fits(const std::string& pattern, const std::string& text) {
  return ::fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
}

bool is_selected(const Cell& cell, const std::string& only) {
  return only.empty() || fits(only, cell.scene) || fits(only, cell.call.text()) ||
         fits(only, std::string(cell.call.row->name)) || fits(only, cell.name());
}

std::vector<Job> make_jobs(const Study& study, const StudyOptions& options) {
  std::vector<Job> jobs;
  for (const Cell& cell : expand_cells(study))
    jobs.push_back({cell, CellFiles(options.folder, cell),
                    cell_fingerprint(cell, study.reference, study.repeats, options.context),
                    is_selected(cell, options.only)});
  for (Job& job : jobs)
    if (job.cell.call.given) job.cell.place.folder = job.files.given();
  if (std::none_of(jobs.begin(), jobs.end(), [](const Job& job) { return job.selected; }))
    throw InputError(
        fmt::format("--only '{}': fits no cell; accepted: a pattern of SCENE, METHOD "
                    "or SCENE/METHOD:PARAMETERS, such as '{}'",
                    options.only, jobs.back().cell.name()));
  return jobs;
}

/// Cells that this run does not have to compute: all that its build has finished when it resumes;
/// and those that it leaves out. Rows that this run will replace go first, so that a kill can't
/// leave them to be taken for its own.
void read_known_rows(std::vector<Job>& jobs, const StudyOptions& options) {
  ContentHashes hashes;
  for (Job& job : jobs) {
    if (options.resume || !job.selected)
      job.row = read_finished(job.files, job.fingerprint, hashes);
    const bool of_this_build = job.row && job.row->machine["build"] == options.build;
    if (!job.selected || (options.resume && of_this_build)) continue;
    job.row.reset();
    fs::remove(job.files.row());
  }
}

/// The scene and its reference, loaded when the first cell asks for them.
class SceneAtHand {
 public:
  SceneAtHand(fs::path file, const std::optional<MethodCall>& opacities,
              const scene::RenderContext& context)
      : file_(std::move(file)), opacities_(opacities), context_(context) {}

  const scene::Scene& scene() {
    if (!scene_) scene_ = load();
    return *scene_;
  }
  /// Read back as it was stored, so that every run of a cell compares with the same bits.
  void set_reference(const CellFiles& files) { reference_files_ = files; }
  const Image& reference() {
    if (reference_.pixels.empty()) reference_ = read_image(reference_files_->picture());
    return reference_;
  }
  const CountImage& reference_layers() {
    if (layers_.pixels.empty()) layers_ = read_counts(reference_files_->layers());
    return layers_;
  }
  bool has_reference_layers() const { return fs::exists(reference_files_->layers()); }

  /// What the reference was made of counts for the cells that are compared with it.
  void reads_also(std::map<std::string, std::string> files) {
    files_of_reference_ = std::move(files);
  }
  /// What has been read to draw the scene and its reference, with the hash of its content.
  std::map<std::string, std::string> files_read() {
    std::map<std::string, std::string> files = files_of_reference_;
    for (const fs::path& path : read_.paths()) files.emplace(path.string(), hashes_.of(path));
    return files;
  }

 private:
  std::unique_ptr<scene::Scene> load() const {
    auto scene = std::make_unique<scene::Scene>(scene::load_scene(file_));
    if (opacities_) optimize_opacities(*opacities_, context_, *scene);
    return scene;
  }

  FilesRead read_;
  ContentHashes hashes_;
  std::map<std::string, std::string> files_of_reference_;
  fs::path file_;
  const std::optional<MethodCall>& opacities_;
  const scene::RenderContext& context_;
  std::unique_ptr<scene::Scene> scene_;
  std::optional<CellFiles> reference_files_;
  Image reference_;
  CountImage layers_;
};

void write_picture(const CellFiles& files, const CellMeasurement& measured) {
  write_image(files.picture(), measured.image);
  write_image(files.preview(), measured.image);
  if (!measured.layers.pixels.empty()) write_counts(files.layers(), measured.layers);
}

void write_further(const CellFiles& files, const CellMeasurement& measured) {
  for (std::size_t i = 0; i < measured.further.size(); ++i)
    write_image(files.further(measured.row.pictures[i].name), measured.further[i]);
}

/// The layers that are known tell covered pixels, and those where layers agree, from the others.
PairRegions regions_of(const CellMeasurement& measured, SceneAtHand& at_hand) {
  return {
      .mask = nullptr,
      .reference_layers = at_hand.has_reference_layers() ? &at_hand.reference_layers() : nullptr,
      .test_layers = measured.layers.pixels.empty() ? nullptr : &measured.layers};
}

void compare_with_reference(const Job& job, CellMeasurement& measured, SceneAtHand& at_hand) {
  const Image& reference = at_hand.reference();
  const PairRegions regions = regions_of(measured, at_hand);
  const PicturePair pair(reference, measured.image, regions);
  measured.row.metrics = compare_pair(pair);
  if (job.cell.reference) return;
  write_image(job.files.error_map(), error_map(reference, measured.image));
  write_image(job.files.flip_map(), flip_picture(pair.flip()));
  if (regions.reference_layers) add_layer_error(reference, *regions.reference_layers, measured);
  if (job.cell.call.given)
    measured.row.given_faults = given_faults(reference, measured.image, at_hand.scene().background);
  const scene::Promises& promises = job.cell.call.row->promises;
  if ((promises.exact || promises.own_layers) && regions.reference_layers && regions.test_layers)
    measured.row.coverage =
        check_coverage(reference, *regions.reference_layers, measured.image, measured.layers);
}

bool makes_layers(const MethodCall& call) { return call.row->promises.own_layers; }

ResultRow compute(const Job& job, SceneAtHand& at_hand, const Study& study,
                  const scene::RenderContext& context) {
  CellMeasurement measured = measure_cell(job.cell, at_hand.scene(), study.repeats, context);
  const bool beside_layers =
      job.cell.reference && std::any_of(study.methods.begin(), study.methods.end(), makes_layers);
  if (makes_layers(job.cell.call) || beside_layers) add_layer_picture(measured);
  write_picture(job.files, measured);
  if (job.cell.reference) at_hand.set_reference(job.files);
  compare_with_reference(job, measured, at_hand);
  if (makes_layers(job.cell.call) && !job.cell.reference && at_hand.has_reference_layers())
    add_layer_difference(at_hand.reference_layers(), measured);
  for (const std::string& name : job.cell.measures)
    find_row("measure", name, study_measures())
        .measure(at_hand.scene(), at_hand.reference(), measured);
  write_further(job.files, measured);
  measured.row.fingerprint = job.fingerprint;
  measured.row.files_read = at_hand.files_read();
  return measured.row;
}

ResultRow failed(const Job& job, const std::string& why) {
  ResultRow row = identity_row(job.cell);
  row.fingerprint = job.fingerprint;
  row.error = why;
  return row;
}

/// An adverse cell must not take the others with it: any exception becomes its row's error.
ResultRow compute_or_fail(const Job& job, SceneAtHand& at_hand, const Study& study,
                          const scene::RenderContext& context) {
  try {
    return compute(job, at_hand, study, context);
  } catch (const std::exception& error) {
    return failed(job, one_line(error.what()));
  }
}

class StudyRun {
 public:
  StudyRun(const Study& study, const StudyOptions& options)
      : study_(study), options_(options), jobs_(make_jobs(study, options)) {
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
    SceneAtHand at_hand(jobs.back().cell.scene_file, study_.opacities, options_.context);
    SceneAtHand of_reference(reference.cell.scene_file, study_.opacities, options_.context);
    const bool one_scene = reference.cell.scene_file == jobs.back().cell.scene_file;
    if (!reference.row) run_job(reference, one_scene ? at_hand : of_reference);
    at_hand.set_reference(reference.files);
    at_hand.reads_also(reference.row->files_read);
    for (Job& job : jobs.subspan(1))
      if (pending(job)) reference.row->error.empty() ? run_job(job, at_hand) : skip(job);
  }

  void run_job(Job& job, SceneAtHand& at_hand) {
    report(options_.progress, progress(), job.cell.name());
    ResultRow row = compute_or_fail(job, at_hand, study_, options_.context);
    row.machine["build"] = options_.build;
    record(job, std::move(row));
  }

  void skip(Job& job) { record(job, failed(job, "its scene's reference failed")); }

  /// Where no row can be written, on a full disk, the study ends.
  void record(Job& job, ResultRow row) {
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
    if (study_.published)
      write_text(options_.folder / "costs.csv", csv_costs(study_, outcome_.rows));
    write_report(options_.folder, study_, outcome_.rows);
  }

  const Study& study_;
  const StudyOptions& options_;
  std::vector<Job> jobs_;
  StudyOutcome outcome_;
};

}  // namespace

StudyOutcome run_study(const Study& study, const StudyOptions& options) {
  return StudyRun(study, options).run();
}

}  // namespace pellucid::compare
