// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/report_cells.h"

namespace pellucid::compare {
namespace {

const ResultRow* find(std::span<const ResultRow> rows, const Cell& cell) {
  for (const ResultRow& row : rows)
    if (row.scene == cell.scene && row.method == cell.call.row->name &&
        row.parameters == cell.call.parameters.given())
      return &row;
  return nullptr;
}

}  // namespace

std::vector<ReportCell> report_cells(const std::filesystem::path& folder, const Study& study,
                                     std::span<const ResultRow> rows) {
  std::vector<ReportCell> list;
  std::optional<std::size_t> reference;
  for (const Cell& cell : expand_cells(study)) {
    if (cell.reference) reference.reset();
    const ResultRow* row = find(rows, cell);
    if (!row) continue;
    if (cell.reference && row->error.empty()) reference = list.size();
    list.push_back({cell, row, CellFiles(folder, cell), reference.value_or(list.size())});
  }
  return list;
}

}  // namespace pellucid::compare
