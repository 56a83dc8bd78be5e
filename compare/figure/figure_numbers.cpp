// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/figure_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/results/best_row.h"
#include "compare/results/columns.h"
#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

/// 0.0213, 2604, 1.23·10⁻⁴: papers print few errors below a thousandth, and few numbers above a
/// million.
std::vector<TextRun> scientific_runs(double value) {
  const double size = std::abs(value);
  if (size == 0) return {{"0"}};
  if (!std::isfinite(value)) return {{fmt::format("{}", value)}};
  if (size >= 999.5 && size < 1e6) return {{fmt::format("{:.0f}", value)}};
  if (size >= 1e-3 && size < 1e6) return {{fmt::format("{:#.3g}", value)}};
  const std::string text = fmt::format("{:.2e}", value);
  const std::size_t e = text.find('e');
  return {{text.substr(0, e) + "·10"},
          {.text = std::to_string(std::stoi(text.substr(e + 1))), .is_raised = true}};
}

std::vector<TextRun> with_unit(const Column& column, const ResultRow& row) {
  std::vector<TextRun> runs = plain_number(column, row);
  const std::string_view unit = unit_for_people(column.style);
  if (!unit.empty() && column.value(row)) runs.back().text += fmt::format(" {}", unit);
  return runs;
}

/// A cost's unit says what it is; all else has its name.
std::vector<TextRun> number_runs(const Column& column, const ResultRow& row,
                                 std::span<const ResultRow> rows) {
  const bool is_bold = is_best_of_several(column, row, rows);
  std::vector<TextRun> runs;
  if (column.shown.role != TradeOff::cost) runs.push_back({column.title + " "});
  for (TextRun& run : with_unit(column, row)) {
    run.is_bold = is_bold;
    runs.push_back(std::move(run));
  }
  if (is_bold && is_only_tied(column, row, rows)) runs.push_back({.text = "*", .is_raised = true});
  return runs;
}

}  // namespace

/// "flicker" is the change of the error, which no metric has in its name.
bool is_error(const Column& column) {
  if (column.name == "flicker") return true;
  return std::ranges::any_of(
      metrics(), [&](const MetricRow& metric) { return column.name.starts_with(metric.name); });
}

std::vector<TextRun> plain_number(const Column& column, const ResultRow& row) {
  const std::optional<double> value = column.value(row);
  if (!value) return {{"–"}};
  if (column.style == NumberStyle::scientific) return scientific_runs(*value);
  return {{number_for_people(column.style, *value)}};
}

bool is_best_of_several(const Column& column, const ResultRow& row,
                        std::span<const ResultRow> rows) {
  return is_among_best(column, row, rows) &&
         std::ranges::count(rows, false, &ResultRow::reference) > 1;
}

bool is_only_tied(const Column& column, const ResultRow& row, std::span<const ResultRow> rows) {
  return column.value(row) != column.value(*best_row(column, rows));
}

std::vector<FigureNumbers> figure_numbers(const FigureRows& scene,
                                          const std::vector<std::string>& names) {
  std::vector<FigureNumbers> numbers(scene.rows.size());
  for (std::size_t i = 0; i < scene.rows.size(); ++i)
    if (scene.rows[i].reference) numbers[i].errors.push_back({{"reference"}});
  for (const std::string& name : names) {
    const Column column = column_named(name, scene.rows);
    for (std::size_t i = 0; i < scene.rows.size(); ++i) {
      const ResultRow& row = scene.rows[i];
      if (row.reference && is_error(column)) continue;
      auto& list = is_error(column) ? numbers[i].errors : numbers[i].costs;
      list.push_back(number_runs(column, row, scene.rows));
    }
  }
  return numbers;
}

}  // namespace pellucid::compare
