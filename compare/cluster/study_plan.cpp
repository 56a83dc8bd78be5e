// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/study_plan.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>

#include "compare/cells/known_cell.h"
#include "compare/run/study_jobs.h"
#include "core/files/json_text.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

bool is_timed(const Cell& cell, const TimingRule& timing) {
  const bool is_there_already = cell.call.given && cell.call.given->kind() == "picture";
  return timing.max > 1 && !is_there_already;
}

void read_rows(std::span<Job> jobs, ContentHashes& hashes) {
  for (Job& job : jobs) job.row = read_finished(job.files, job.fingerprint, hashes);
}

/// The row of the cell, or else the one of its scene that took longest: rather too much time than
/// too little.
const ResultRow* known_row(const Job& job, std::span<const Job> of_scene) {
  if (job.row) return &*job.row;
  const ResultRow* longest = nullptr;
  for (const Job& other : of_scene)
    if (other.row && (!longest || other.row->seconds.median > longest->seconds.median))
      longest = &*other.row;
  return longest;
}

PlannedCell planned(const Job& job, std::span<const Job> of_scene, const SceneSize& size,
                    const TimingRule& timing, const std::string& build) {
  PlannedCell cell;
  cell.cell = job.cell.name();
  if (!job.cell.reference) cell.needs = {of_scene.front().cell.name()};
  cell.scene = job.cell.scene;
  cell.scene_file = job.cell.scene_file.string();
  cell.size = size;
  cell.estimate = estimate_cell(size, timing, known_row(job, of_scene));
  cell.timed = is_timed(job.cell, timing);
  cell.done = job.row && is_of_build(*job.row, build);
  return cell;
}

}  // namespace

std::vector<PlannedCell> plan_study(const Study& study, const StudyOptions& options) {
  std::vector<Job> jobs = make_jobs(study, options);
  ContentHashes hashes;
  std::vector<PlannedCell> plan;
  const std::size_t cells_per_scene = 1 + study.methods.size();
  for (std::size_t first = 0; first < jobs.size(); first += cells_per_scene) {
    const auto of_scene = std::span(jobs).subspan(first, cells_per_scene);
    read_rows(of_scene, hashes);
    const SceneSize size = scene_size(of_scene.back().cell.scene_file, study.views);
    for (const Job& job : of_scene)
      plan.push_back(planned(job, of_scene, size, timing_of(study), options.build));
  }
  return plan;
}

// Counts are whole; of seconds more than milliseconds would be no estimate.
std::string plan_line(const PlannedCell& planned) {
  const auto count = [](double value) { return std::uint64_t(value); };
  return json_text({{"cell", planned.cell},
                    {"needs", planned.needs},
                    {"scene", planned.scene},
                    {"scene_file", planned.scene_file},
                    {"pixels", count(planned.size.views * planned.size.pixels)},
                    {"bytes_read", count(planned.size.bytes_read)},
                    {"seconds", std::round(1e3 * planned.estimate.seconds) / 1e3},
                    {"bytes", count(planned.estimate.bytes)},
                    {"timed", planned.timed},
                    {"done", planned.done}});
}

}  // namespace pellucid::compare
