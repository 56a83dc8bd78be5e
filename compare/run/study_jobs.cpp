// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/run/study_jobs.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <functional>

#include "compare/budget/measure_budget.h"
#include "compare/cells/draw_intervals.h"
#include "compare/cells/known_cell.h"
#include "compare/measures/layers/layer_error.h"
#include "compare/measures/layers/layer_pictures.h"
#include "compare/measures/study_measures.h"
#include "compare/methods/given_method.h"
#include "compare/pictures/error_map.h"
#include "compare/pictures/faults/given_faults.h"
#include "compare/pictures/flip.h"
#include "compare/pictures/image_file.h"
#include "core/error.h"
#include "core/options/names.h"
#include "core/parallel.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

bool fits(const std::string& pattern, const std::string& text) {
  return ::fnmatch(pattern.c_str(), text.c_str(), 0) == 0;
}

bool is_meant(const std::string& pattern, const Cell& cell) {
  return fits(pattern, cell.scene) || fits(pattern, cell.call.text()) ||
         fits(pattern, std::string(cell.call.row->name)) || fits(pattern, cell.name());
}

bool is_selected(const Cell& cell, const std::vector<std::string>& only) {
  return only.empty() ||
         std::ranges::any_of(only, [&](const auto& pattern) { return is_meant(pattern, cell); });
}

/// What fits nothing is a slip of the hand.
void check_patterns(const std::vector<std::string>& only, const std::vector<Job>& jobs) {
  for (const std::string& pattern : only)
    if (std::ranges::none_of(jobs, [&](const Job& job) { return is_meant(pattern, job.cell); }))
      throw InputError(
          fmt::format("--only '{}': fits no cell; accepted: a pattern of SCENE, METHOD "
                      "or SCENE/METHOD:PARAMETERS, such as '{}'",
                      pattern, jobs.back().cell.name()));
}

/// Files of one cell are encoded and written at once: nothing is timed meanwhile.
void write_at_once(const std::vector<std::function<void()>>& writes) {
  parallel_for(std::size_t(0), writes.size(), [&](std::size_t i) { writes[i](); });
}

void write_picture(const CellFiles& files, const CellMeasurement& measured,
                   const PictureForm& form) {
  write_at_once({[&] { write_image(files.picture(), measured.image, form); },
                 [&] { write_image(files.preview(), measured.image, form); },
                 [&] {
                   if (!measured.layers.pixels.empty())
                     write_counts(files.layers(), measured.layers, form);
                 }});
}

void write_maps(const CellFiles& files, const PicturePair& pair) {
  const Raster<float>& flip = pair.flip();
  write_at_once({[&] {
                   write_image(files.error_map(), error_map(pair.reference(), pair.test()),
                               form_of_error_map());
                 },
                 [&] { write_image(files.flip_map(), flip_picture(flip), form_of_flip()); }});
}

void write_further(const CellFiles& files, const CellMeasurement& measured) {
  for (std::size_t i = 0; i < measured.further.size(); ++i)
    write_image(files.further(measured.row.pictures[i].name), measured.further[i],
                form_of_map(measured.row.pictures[i].title));
}

/// The layers that are known tell covered pixels, and those where layers agree, from the others.
PairRegions regions_of(const CellMeasurement& measured, SceneAtHand& at_hand) {
  return {
      .mask = nullptr,
      .reference_layers = at_hand.has_reference_layers() ? &at_hand.reference_layers() : nullptr,
      .test_layers = measured.layers.pixels.empty() ? nullptr : &measured.layers};
}

void compare_with_reference(const Job& job, const CellFiles& files, CellMeasurement& measured,
                            SceneAtHand& at_hand) {
  const Image& reference = at_hand.reference();
  const PairRegions regions = regions_of(measured, at_hand);
  const PicturePair pair(reference, measured.image, regions);
  measured.row.metrics = compare_pair(pair);
  measured.row.metric_intervals = intervals_over_draws(reference, measured, regions);
  if (job.cell.reference) return;
  write_maps(files, pair);
  if (regions.reference_layers) add_layer_error(reference, *regions.reference_layers, measured);
  if (job.cell.call.given)
    measured.row.given_faults = given_faults(reference, measured.image, at_hand.scene().background);
  const scene::Promises& promises = job.cell.call.row->promises;
  if ((promises.exact || promises.own_layers) && regions.reference_layers && regions.test_layers)
    measured.row.coverage =
        check_coverage(reference, *regions.reference_layers, measured.image, measured.layers);
}

/// A picture that was made of one scene or view is none of others.
void add_shared_picture(const MethodCall& call, const Study& study, ResultRow& row) {
  const std::pair<std::string_view, bool> several[] = {{"scene", study.scenes.size() > 1},
                                                       {"view", study.views.any()}};
  for (const auto& [what, is_several] : several)
    if (call.given && is_several && !call.given->tells_apart(what))
      row.given_faults.push_back(
          fmt::format("stands for several {0}s: its name has no {{{0}}}", what));
}

PictureCall call_of(const Cell& cell) {
  return {cell.call.text(), cell.opacities ? cell.opacities->text() : "", false};
}

bool makes_layers(const MethodCall& call) { return call.row->promises.own_layers; }

}  // namespace

Job make_job(const Study& study, const Cell& cell, const StudyOptions& options) {
  return {cell, CellFiles(options.folder, cell),
          cell_fingerprint(cell, study.reference, timing_of(study), options.context)};
}

std::vector<Job> make_jobs(const Study& study, const StudyOptions& options) {
  std::vector<Job> jobs;
  for (const Cell& cell : expand_cells(study)) {
    jobs.push_back(make_job(study, cell, options));
    jobs.back().selected = is_selected(cell, options.only);
  }
  check_patterns(options.only, jobs);
  return jobs;
}

void read_known_rows(std::vector<Job>& jobs, const StudyOptions& options) {
  ContentHashes hashes;
  for (Job& job : jobs) {
    if (options.resume || !job.selected)
      job.row = read_finished(job.files, job.fingerprint, hashes);
    const bool of_this_build = job.row && is_of_build(*job.row, options.build);
    if (!job.selected || (options.resume && of_this_build)) continue;
    job.row.reset();
    fs::remove(job.files.row());
  }
}

ResultRow failed_row(const Job& job, const std::string& why) {
  ResultRow row = identity_row(job.cell);
  row.fingerprint = job.fingerprint;
  row.error = why;
  return row;
}

void finish_view(const Job& job, CellMeasurement measured, SceneAtHand& at_hand, const Study& study,
                 ViewRows& rows) {
  const CellFiles files = job.files.from(at_hand.view());
  const bool beside_layers =
      job.cell.reference && std::any_of(study.methods.begin(), study.methods.end(), makes_layers);
  if (makes_layers(job.cell.call) || beside_layers) add_layer_picture(measured);
  write_picture(files, measured, form_of_picture(at_hand.scene(), call_of(job.cell)));
  if (job.cell.reference) at_hand.set_reference(job.files);
  compare_with_reference(job, files, measured, at_hand);
  add_shared_picture(job.cell.call, study, measured.row);
  if (makes_layers(job.cell.call) && !job.cell.reference && at_hand.has_reference_layers())
    add_layer_difference(at_hand.reference_layers(), measured);
  if (job.cell.budget && at_hand.view() == 0)
    add_budget(job.cell, study.reference, at_hand.scene(), at_hand.context(), measured);
  const MeasuredScene of{at_hand.scene(), at_hand.reference(),
                         [&]() -> const RayFacts& { return at_hand.ray_facts(); }};
  for (const std::string& name : job.cell.measures)
    find_row("measure", name, study_measures()).measure(of, measured);
  write_further(files, measured);
  rows.add(std::move(measured.row), at_hand.reference(), measured.image);
}

ResultRow finished_row(const Job& job, const ViewRows& rows, SceneAtHand& at_hand) {
  ResultRow row = rows.row();
  row.fingerprint = job.fingerprint;
  row.files_read = at_hand.files_read();
  return row;
}

void finish_job(Job& job, ResultRow row, const StudyOptions& options) {
  row.machine["build"] = options.build;
  row.machine["gl"] = options.context.gl;
  write_row(job.files, row);
  job.row = std::move(row);
}

}  // namespace pellucid::compare
