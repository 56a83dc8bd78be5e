// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compare/changes/number_changes.h"
#include "compare/changes/picture_changes.h"
#include "compare/results/provenance.h"
#include "core/error.h"

namespace pellucid::compare {
namespace {

namespace fs = std::filesystem;

/// By file names, since a run elsewhere reads its inputs from another folder.
std::set<std::string> names_and_hashes(const ResultRow& row) {
  std::set<std::string> inputs;
  for (const auto& [path, hash] : inputs_of(row))
    inputs.insert(fs::path(path).filename().string() + "\n" + hash);
  return inputs;
}

std::vector<std::string> causes(const ResultRow& before, const ResultRow& after) {
  std::vector<std::string> why;
  if (before.fingerprint != after.fingerprint)
    why.emplace_back("it was asked for otherwise: its scene, parameters, repeats or views");
  const std::set<std::string> a = names_and_hashes(before), b = names_and_hashes(after);
  std::set<std::string> names;
  std::vector<std::string> others;
  std::ranges::set_symmetric_difference(a, b, std::back_inserter(others));
  for (const std::string& other : others) names.insert(other.substr(0, other.find('\n')));
  for (const std::string& name : names) why.push_back(fmt::format("{} has other content", name));
  return why;
}

/// Of a cell that failed there is nothing but its error; one error is no worse than another.
void compare_errors(const ResultRow& before, const ResultRow& after, CellChange& change) {
  if (before.error == after.error) return;
  const auto text = [](const ResultRow& row) { return row.error.empty() ? "done" : row.error; };
  std::optional<bool> better;
  if (before.error.empty() != after.error.empty()) better = after.error.empty();
  change.numbers.push_back({"Outcome", text(before), text(after), false, better});
}

CellChange compare_cells(const PastRun& before, const PastRun& after, const ResultRow& a,
                         const ResultRow& b) {
  CellChange change{cell_name(a), CellChange::Kind::same, {}, {}, {}};
  if (a.error.empty() && b.error.empty()) {
    change.numbers = number_changes(a, b);
    change.pictures = picture_changes(before, after, a, b);
  } else {
    compare_errors(a, b, change);
  }
  if (change.numbers.empty() && change.pictures.empty()) return change;
  change.kind = CellChange::Kind::changed;
  change.causes = causes(a, b);
  return change;
}

void check_one_study(const PastRun& before, const PastRun& after) {
  const bool common = std::ranges::any_of(
      before.rows, [&](const ResultRow& row) { return find_row_of(after, cell_name(row)); });
  if (before.study == after.study && common) return;
  throw InputError(
      fmt::format("{} against {}: {}; accepted: results of one study", after.folder.string(),
                  before.folder.string(),
                  common ? fmt::format("of study '{}', not of '{}'", after.study, before.study)
                         : "they have no cell in common"));
}

bool counts(const CellChange& cell, bool times_count) {
  if (cell.kind == CellChange::Kind::same) return false;
  if (cell.kind != CellChange::Kind::changed) return true;
  return std::ranges::any_of(cell.pictures, &PictureChange::beyond_rounding) ||
         std::ranges::any_of(cell.numbers,
                             [&](const NumberChange& n) { return times_count || !n.is_time; });
}

}  // namespace

bool RunChanges::differ(bool times_count) const {
  return std::ranges::any_of(cells, [&](const CellChange& c) { return counts(c, times_count); });
}

RunChanges compare_runs(const PastRun& before, const PastRun& after) {
  check_one_study(before, after);
  RunChanges changes;
  for (const ResultRow& a : before.rows) {
    const ResultRow* b = find_row_of(after, cell_name(a));
    changes.cells.push_back(b ? compare_cells(before, after, a, *b)
                              : CellChange{cell_name(a), CellChange::Kind::missing, {}, {}, {}});
  }
  for (const ResultRow& b : after.rows)
    if (!find_row_of(before, cell_name(b)))
      changes.cells.push_back({cell_name(b), CellChange::Kind::added, {}, {}, {}});
  std::vector<ResultRow> rows = before.rows;
  rows.insert(rows.end(), after.rows.begin(), after.rows.end());
  changes.warnings = provenance_warnings(rows);
  return changes;
}

}  // namespace pellucid::compare
