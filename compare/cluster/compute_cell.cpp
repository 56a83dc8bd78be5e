// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cluster/compute_cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "compare/cells/known_cell.h"
#include "compare/run/batch_meter.h"
#include "core/error.h"
#include "core/files/file_lock.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

const Cell& cell_named(const std::string& name, const std::vector<Cell>& cells) {
  const auto found = std::ranges::find(cells, name, &Cell::name);
  if (found != cells.end()) return *found;
  std::vector<std::string> names;
  for (const Cell& cell : cells) names.push_back(cell.name());
  throw InputError(
      "--cell: " +
      unknown_name("cell", name, {std::vector<std::string_view>(names.begin(), names.end())}));
}

const Cell& reference_of(const Cell& cell, const std::vector<Cell>& cells) {
  return *std::ranges::find_if(
      cells, [&](const Cell& other) { return other.reference && other.scene == cell.scene; });
}

/// A LoneCell is a cell that is computed without the others of its scene.
class LoneCell {
 public:
  LoneCell(const Study& study, const Cell& cell, const StudyOptions& options)
      : study_(study), options_(options), job_(make_job(study, cell, options)) {}

  ResultRow compute(const Cell& reference) {
    std::optional<Job> need;
    if (!job_.cell.reference) need = finished_need(reference);
    job_.files.make_folders();
    const FileLock one_at_a_time(job_.files.lock());
    if (auto known = known_row(); known && options_.resume) return std::move(*known);
    if (need && !need->row->error.empty()) return finished(failed_row(job_, reference_failed));
    return measured(need);
  }

 private:
  /// Who compares with this cell meanwhile may go on: what takes the place of a row of this build
  /// are the same pictures. Any other row goes first, so that a kill cannot leave it to be taken
  /// for that of new pictures.
  std::optional<ResultRow> known_row() {
    std::optional<ResultRow> row = read_finished(job_.files, job_.fingerprint, hashes_);
    if (row && is_of_build(*row, options_.build)) return row;
    fs::remove(job_.files.row());
    return std::nullopt;
  }

  Job finished_need(const Cell& reference) {
    Job need = make_job(study_, reference, options_);
    KnownCell known = known_cell(need.files, need.fingerprint, hashes_);
    if (!known.row)
      throw WorkError(
          fmt::format("{} needs {}, which is {}in {}{}; before it: --cell '{}'", job_.cell.name(),
                      need.cell.name(), known.fault.empty() ? "not " : "", options_.folder.string(),
                      known.fault.empty() ? "" : ", but " + known.fault, need.cell.name()));
    need.row = std::move(known.row);
    return need;
  }

  ResultRow measured(const std::optional<Job>& need) {
    BatchMeter meter(study_, options_);
    SceneAtHand at_hand(job_.cell.scene_file, study_, options_.context);
    if (need) {
      at_hand.set_reference(need->files);
      at_hand.reads_also(need->row->files_read);
    }
    report(options_.progress, 0, job_.cell.name());
    const std::vector<Finding> findings = meter.measure({&job_}, at_hand);
    return finished(meter.row_of(job_, findings.front(), at_hand));
  }

  ResultRow finished(ResultRow row) {
    finish_job(job_, std::move(row), options_);
    return *job_.row;
  }

  const Study& study_;
  const StudyOptions& options_;
  Job job_;
  ContentHashes hashes_;
};

}  // namespace

ResultRow compute_cell(const Study& study, const std::string& name, const StudyOptions& options) {
  const std::vector<Cell> cells = expand_cells(study);
  const Cell& cell = cell_named(name, cells);
  return LoneCell(study, cell, options).compute(reference_of(cell, cells));
}

}  // namespace pellucid::compare
