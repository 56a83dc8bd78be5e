// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/columns.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace pellucid::compare {
namespace {

/// Metrics that lead the columns: the contract of results.csv begins with them.
constexpr std::size_t leading_metrics = 3;

/// A metric of the float pictures.
Column metric_column(std::size_t row) {
  const MetricRow& metric = metrics()[row];
  return {.name = std::string(metric.name),
          .heading = std::string(metric.heading),
          .unit = std::string(metric.unit),
          .better = metric.better,
          .style = metric.style,
          .in_tables = row < leading_metrics,
          .in_report = true,
          .value = [row](const ResultRow& r) { return r.metrics.linear[row]; }};
}

/// The same of what a screen shows.
Column displayed_column(std::size_t row) {
  Column column = metric_column(row);
  column.name += "_8bit";
  column.heading += ", 8 bits";
  column.in_tables = false;
  column.in_report = metrics()[row].name == "ssim";
  column.value = [row](const ResultRow& r) { return r.metrics.displayed[row]; };
  return column;
}

template <class T>
std::optional<double> number(T value) {
  return double(value);
}

using Style = NumberStyle;

std::vector<Column> cost_columns() {
  return {{"seconds", "Time [ms]", "s", Better::lower, Style::milliseconds, true, true,
           [](const ResultRow& r) { return number(r.seconds.median); }},
          {"bytes", "Memory [MB]", "bytes", Better::lower, Style::megabytes, true, true,
           [](const ResultRow& r) { return number(r.total_bytes()); }},
          {"fragments", "Fragments", "1", Better::neither, Style::count, true, true,
           [](const ResultRow& r) { return number(r.fragments); }},
          {"max_layers", "Layers", "1", Better::neither, Style::count, true, true,
           [](const ResultRow& r) { return number(r.max_layers); }}};
}

std::vector<Column> further_columns() {
  return {
      {"seconds_min", "Least time [ms]", "s", Better::lower, Style::milliseconds, false, false,
       [](const ResultRow& r) { return number(r.seconds.min); }},
      {"seconds_max", "Longest time [ms]", "s", Better::lower, Style::milliseconds, false, false,
       [](const ResultRow& r) { return number(r.seconds.max); }},
      {"setup_seconds", "Setting up [ms]", "s", Better::lower, Style::milliseconds, false, false,
       [](const ResultRow& r) { return number(r.setup_seconds); }},
      {"dropped", "Dropped fragments", "1", Better::lower, Style::count, false, false,
       [](const ResultRow& r) { return number(r.dropped); }},
      {"stored", "Stored fragments", "1", Better::neither, Style::count, false, false,
       [](const ResultRow& r) { return number(r.stored); }},
      {"truncated_pixels", "Pixels that lost fragments", "1", Better::lower, Style::count, false,
       false, [](const ResultRow& r) { return number(r.truncated); }},
      {"layers_differ", "Pixels of other layers", "1", Better::lower, Style::count, false, false,
       [](const ResultRow& r) {
         return r.coverage ? number(r.coverage->differing) : std::nullopt;
       }},
      {"rmse_equal_layers", "RMSE where layers agree", "1", Better::lower, Style::scientific, false,
       false,
       [](const ResultRow& r) { return r.coverage ? r.coverage->rmse_elsewhere : std::nullopt; }}};
}

std::vector<Column> make_columns() {
  std::vector<Column> all;
  const auto append = [&](std::vector<Column> more) {
    for (Column& column : more) all.push_back(std::move(column));
  };
  for (std::size_t row = 0; row < leading_metrics; ++row) all.push_back(metric_column(row));
  append(cost_columns());
  for (std::size_t row = leading_metrics; row < metrics().size(); ++row)
    all.push_back(metric_column(row));
  for (std::size_t row = 0; row < metrics().size(); ++row) all.push_back(displayed_column(row));
  append(further_columns());
  return all;
}

struct StyleRow {
  NumberStyle style;
  std::string_view name;
  std::string (*text)(double);
};

std::string scientific(double x) { return x == 0 ? "0" : fmt::format("{:.2e}", x); }
std::string one_decimal(double x) { return std::isinf(x) ? "∞" : fmt::format("{:.1f}", x); }

constexpr StyleRow styles[] = {
    {Style::scientific, "scientific", scientific},
    {Style::similarity, "similarity", [](double x) { return fmt::format("{:.4f}", x); }},
    {Style::decibels, "decibels", one_decimal},
    {Style::milliseconds, "milliseconds", [](double x) { return one_decimal(x * 1e3); }},
    {Style::megabytes, "megabytes", [](double x) { return one_decimal(x / 1e6); }},
    {Style::count, "count", [](double x) { return fmt::format("{:.0f}", x); }}};

const StyleRow& row_of(NumberStyle style) { return styles[std::size_t(style)]; }

}  // namespace

std::span<const Column> columns() {
  static const std::vector<Column> table = make_columns();
  return table;
}

bool is_better(const Column& column, double a, double b) {
  if (column.better == Better::neither) return false;
  return column.better == Better::lower ? a < b : a > b;
}

std::string number_for_people(NumberStyle style, double value) { return row_of(style).text(value); }

std::string_view name_of(NumberStyle style) { return row_of(style).name; }

std::string_view name_of(Better better) {
  constexpr std::string_view names[] = {"lower", "higher", "neither"};
  return names[std::size_t(better)];
}

}  // namespace pellucid::compare
