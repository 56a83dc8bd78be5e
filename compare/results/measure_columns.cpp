// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/measure_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/options/names.h"

namespace pellucid::compare {
namespace {

auto find(std::span<const scene::Measure> measures, std::string_view name) {
  return std::find_if(measures.begin(), measures.end(),
                      [&](const scene::Measure& m) { return m.name == name; });
}

const Column* find_column(std::string_view name) {
  const auto found = std::ranges::find(columns(), name, &Column::name);
  return found == columns().end() ? nullptr : &*found;
}

/// What is whole in every row is a count, whatever its size.
bool is_count(std::string_view name, std::span<const ResultRow> rows) {
  return std::ranges::all_of(rows, [&](const ResultRow& row) {
    const std::optional<double> value = measure_of(row, name);
    return !value || (std::isfinite(*value) && *value == std::floor(*value));
  });
}

Column column_of(const scene::Measure& measure, std::span<const ResultRow> rows) {
  std::string_view of = measure.name;
  if (of.ends_with("_worst")) of.remove_suffix(std::string_view("_worst").size());
  const Column* metric = find_column(of);
  return {.name = measure.name,
          .title = measure.title,
          .unit = measure.unit,
          .better = measure.better,
          .style = metric                         ? metric->style
                   : is_count(measure.name, rows) ? NumberStyle::count
                                                  : NumberStyle::scientific,
          .shown = {},
          .value = [name = measure.name](const ResultRow& row) { return measure_of(row, name); }};
}

}  // namespace

Column column_named(std::string_view name, std::span<const ResultRow> rows) {
  if (const Column* column = find_column(name)) return *column;
  const std::vector<scene::Measure> measures = measure_columns(rows);
  const auto measure = find(measures, name);
  if (measure != std::span(measures).end()) return column_of(*measure, rows);
  std::vector<std::string_view> known;
  for (const Column& column : columns()) known.push_back(column.name);
  for (const scene::Measure& one : measures) known.push_back(one.name);
  throw InputError(unknown_name("column", name, known));
}

std::vector<scene::Measure> measure_columns(std::span<const ResultRow> rows) {
  std::vector<scene::Measure> columns;
  for (const ResultRow& row : rows)
    for (const scene::Measure& measure : row.measures) {
      const std::span<const scene::Measure> known(columns);
      if (find(known, measure.name) == known.end()) columns.push_back(measure);
    }
  return columns;
}

std::optional<double> measure_of(const ResultRow& row, std::string_view name) {
  const std::span<const scene::Measure> measures(row.measures);
  const auto found = find(measures, name);
  return found == measures.end() ? std::nullopt : std::optional(found->value);
}

constexpr std::string_view longest_step = "longest_step";

bool is_of_time(const scene::Measure& measure) {
  return measure.unit == "s" || measure.unit == "ms" || measure.name == longest_step;
}

std::optional<Interval> interval_of_measure(const ResultRow& row, std::string_view name) {
  const std::span<const scene::Measure> measures(row.measures);
  const auto found = find(measures, name);
  if (found == measures.end()) return std::nullopt;
  const Interval itself{found->value, found->value};
  if (!is_of_time(*found)) return itself;
  const auto place = std::size_t(found->value) - 1;
  if (name != longest_step || place >= row.steps.size()) return std::nullopt;
  const auto& longest = row.steps[place].second.interval;
  for (std::size_t i = 0; i < row.steps.size(); ++i)
    if (const auto& other = row.steps[i].second.interval;
        i != place && (!longest || !other || other->high >= longest->low))
      return std::nullopt;
  return itself;
}

int views_of(std::span<const ResultRow> rows) {
  double most = 1;
  for (const ResultRow& row : rows) most = std::max(most, measure_of(row, "views").value_or(1));
  return int(most);
}

std::string heading(const scene::Measure& measure) {
  return measure.unit.empty() ? measure.title : fmt::format("{} [{}]", measure.title, measure.unit);
}

}  // namespace pellucid::compare
