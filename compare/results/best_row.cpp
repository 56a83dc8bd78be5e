// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/best_row.h"

#include <algorithm>

namespace pellucid::compare {

const ResultRow* best_row(const Column& column, std::span<const ResultRow> rows) {
  const ResultRow* best = nullptr;
  if (column.better == Better::neither) return best;
  for (const ResultRow& row : rows) {
    if (row.reference || !row.error.empty() || !column.value(row)) continue;
    if (!best || is_better(column, *column.value(row), *column.value(*best))) best = &row;
  }
  return best;
}

bool is_undecided(const Column& column, std::span<const ResultRow> rows) {
  const ResultRow* best = best_row(column, rows);
  if (!best || !column.interval || place_of(column, *best)) return false;
  return std::ranges::count_if(rows, [&](const ResultRow& row) {
           return !row.reference && row.error.empty() && column.value(row).has_value();
         }) > 1;
}

bool is_among_best(const Column& column, const ResultRow& row, std::span<const ResultRow> rows) {
  const ResultRow* best = best_row(column, rows);
  if (!best || row.reference || !row.error.empty()) return false;
  if (is_undecided(column, rows)) return false;
  return column.value(row) == column.value(*best) || are_tied(column, row, *best);
}

}  // namespace pellucid::compare
