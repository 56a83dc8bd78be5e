// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "compare/cells/cell.h"
#include "compare/results/result_row.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// A ReportCell is a cell of which the report has a row: what it was asked, what it found out, and
/// its files.
struct ReportCell {
  Cell cell;
  const ResultRow* row;
  CellFiles files;
  std::size_t reference;  // place in the list of its scene's reference, or its own where that is
                          // missing or failed

  /// Returns whether it has pictures.
  bool is_done() const { return row->error.empty(); }
};

/// Returns the cells whose row is known, in the study's order: a row's place here is its place in
/// the page's data, and the number in the keys of its pictures.
std::vector<ReportCell> report_cells(const std::filesystem::path& folder, const Study& study,
                                     std::span<const ResultRow> rows);

}  // namespace pellucid::compare
