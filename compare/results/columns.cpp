// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/columns.h"

#include <fmt/format.h>

#include <vector>

namespace pellucid::compare {
namespace {

/// Metrics that lead the columns: the contract of results.csv begins with them.
constexpr std::size_t leading_metrics = 3;

/// A metric of the float pictures.
Column metric_column(std::size_t row) {
  const MetricRow& metric = metrics()[row];
  return {.name = std::string(metric.name),
          .title = std::string(metric.symbol),
          .unit = std::string(metric.unit),
          .better = metric.better,
          .style = metric.style,
          .shown = metric.shown,
          .value = [row](const ResultRow& r) { return r.metrics.linear[row]; },
          .interval =
              [name = std::string(metric.name)](const ResultRow& r) {
                const auto found = r.metric_intervals.find(name);
                return found == r.metric_intervals.end() ? std::nullopt
                                                         : std::optional(found->second);
              }};
}

/// The same of what a screen shows.
Column displayed_column(std::size_t row) {
  Column column = metric_column(row);
  column.name += "_8bit";
  column.title += ", 8 bits";
  column.shown = metrics()[row].shown_displayed;
  column.value = [row](const ResultRow& r) { return r.metrics.displayed[row]; };
  column.interval = nullptr;
  return column;
}

template <class T>
std::optional<double> number(T value) {
  return double(value);
}

/// Of a picture from elsewhere only what its maker told is known.
template <class Known, class Value>
auto unless_given(const Known& known, const Value& value) {
  return [known, value](const ResultRow& r) -> std::optional<double> {
    if (!r.given.empty() && !known(r)) return std::nullopt;
    return double(value(r));
  };
}

bool never(const ResultRow&) { return false; }
bool is_timed(const ResultRow& r) { return !r.steps.empty(); }
bool is_weighed(const ResultRow& r) { return !r.bytes.empty(); }
bool is_counted(const ResultRow& r) { return r.fragments > 0; }

using Style = NumberStyle;

std::optional<Interval> time_interval(const ResultRow& row) { return row.seconds.interval; }

std::optional<Interval> in_milliseconds(const std::optional<Interval>& seconds) {
  return seconds ? std::optional(Interval{1e3 * seconds->low, 1e3 * seconds->high}) : std::nullopt;
}

constexpr Shown in_csv = {};
constexpr Shown in_tables = {.tables = true, .report = true};

constexpr Shown as_cost(bool sweeps) {
  return {.tables = true, .report = true, .card = true, .sweeps = sweeps, .role = TradeOff::cost};
}

std::vector<Column> cost_columns() {
  return {{"seconds", "Time", "s", Better::lower, Style::milliseconds, as_cost(true), known_seconds,
           time_interval},
          {"bytes", "Memory", "bytes", Better::lower, Style::megabytes, as_cost(false),
           unless_given(is_weighed, [](const ResultRow& r) { return r.total_bytes(); })},
          {"fragments", "Fragments", "1", Better::neither, Style::count, in_tables,
           unless_given(is_counted, [](const ResultRow& r) { return r.fragments; })},
          {"max_layers", "Layers", "1", Better::neither, Style::count, in_tables,
           unless_given(never, [](const ResultRow& r) { return r.max_layers; })}};
}

std::vector<Column> further_columns() {
  return {{"covered", "Covered share", "1", Better::neither, Style::similarity, in_csv,
           [](const ResultRow& r) { return r.metrics.linear.covered; }},
          {"seconds_min", "Least time", "s", Better::lower, Style::milliseconds, in_csv,
           unless_given(is_timed, [](const ResultRow& r) { return r.seconds.min; })},
          {"seconds_max", "Longest time", "s", Better::lower, Style::milliseconds, in_csv,
           unless_given(is_timed, [](const ResultRow& r) { return r.seconds.max; })},
          {"setup_seconds", "Setting up", "s", Better::lower, Style::milliseconds, in_csv,
           unless_given(never, [](const ResultRow& r) { return r.setup_seconds; })},
          {"dropped", "Dropped fragments", "1", Better::lower, Style::count, in_csv,
           unless_given(never, [](const ResultRow& r) { return r.dropped; })},
          {"stored", "Stored fragments", "1", Better::neither, Style::count, in_csv,
           unless_given(never, [](const ResultRow& r) { return r.stored; })},
          {"truncated_pixels", "Pixels that lost fragments", "1", Better::lower, Style::count,
           in_csv, unless_given(never, [](const ResultRow& r) { return r.truncated; })},
          {"layers_differ", "Pixels of other layers", "1", Better::lower, Style::count, in_csv,
           [](const ResultRow& r) {
             return r.coverage ? number(r.coverage->differing) : std::nullopt;
           }},
          {"rmse_equal_layers", "RMSE where layers agree", "1", Better::lower, Style::scientific,
           in_csv, [](const ResultRow& r) {
             return r.coverage ? r.coverage->rmse_elsewhere : std::nullopt;
           }}};
}

/// Of the times in milliseconds; the interval's ends are empty where repeats are too few for one.
std::vector<Column> timing_columns() {
  constexpr Style style = Style::plain_milliseconds;
  const auto end = [](double Interval::*which) {
    return [which](const ResultRow& r) {
      return r.seconds.interval ? number(1e3 * (*r.seconds.interval).*which) : std::nullopt;
    };
  };
  return {
      {"ms", "Median time", "ms", Better::lower, style, in_csv,
       unless_given(is_timed, [](const ResultRow& r) { return 1e3 * r.seconds.median; }),
       [](const ResultRow& r) { return in_milliseconds(r.seconds.interval); }},
      {"ms_low", "Median time, low end", "ms", Better::lower, style, in_csv, end(&Interval::low)},
      {"ms_high", "Median time, high end", "ms", Better::lower, style, in_csv,
       end(&Interval::high)},
      {"first_frame_ms", "First picture", "ms", Better::lower, style, in_csv,
       unless_given(never, [](const ResultRow& r) { return 1e3 * r.first_frame_seconds(); })},
      {"gl_ms", "Time by OpenGL's clock", "ms", Better::lower, style, in_csv,
       [](const ResultRow& r) {
         return r.gl_seconds ? number(1e3 * *r.gl_seconds) : std::nullopt;
       }},
      {"repeats", "Timed pictures", "1", Better::neither, Style::count, in_csv,
       unless_given(is_timed, [](const ResultRow& r) { return r.repeats; })}};
}

std::vector<Column> make_columns() {
  std::vector<Column> all;
  const auto append = [&](std::vector<Column> more) {
    for (Column& column : more) all.push_back(std::move(column));
  };
  for (std::size_t row = 0; row < leading_metrics; ++row) all.push_back(metric_column(row));
  append(cost_columns());
  for (std::size_t row = leading_metrics; row < metrics().size(); ++row)
    if (!metrics()[row].on_request) all.push_back(metric_column(row));
  for (std::size_t row = 0; row < metrics().size(); ++row)
    if (metrics()[row].displayed) all.push_back(displayed_column(row));
  append(further_columns());
  append(timing_columns());
  return all;
}

}  // namespace

std::span<const Column> columns() {
  static const std::vector<Column> table = make_columns();
  return table;
}

std::optional<double> known_seconds(const ResultRow& row) {
  return unless_given(is_timed, [](const ResultRow& r) { return r.seconds.median; })(row);
}

bool is_better(const Column& column, double a, double b) {
  if (column.better == Better::neither) return false;
  return column.better == Better::lower ? a < b : a > b;
}

std::optional<Interval> interval_of(const Column& column, const ResultRow& row) {
  return column.interval ? column.interval(row) : std::nullopt;
}

bool is_time(const Column& column) { return column.unit == "s" || column.unit == "ms"; }

std::optional<Interval> place_of(const Column& column, const ResultRow& row) {
  if (const auto interval = interval_of(column, row); interval || is_time(column)) return interval;
  const std::optional<double> value = column.value(row);
  return value ? std::optional(Interval{*value, *value}) : std::nullopt;
}

bool are_tied(const Column& column, const ResultRow& a, const ResultRow& b) {
  if (!interval_of(column, a) && !interval_of(column, b)) return false;
  const std::optional<Interval> of_a = place_of(column, a), of_b = place_of(column, b);
  return of_a && of_b && overlap(*of_a, *of_b);
}

std::string text_with_interval(const Column& column, const ResultRow& row) {
  const std::optional<double> value = column.value(row);
  if (!value) return "–";
  const std::string text = number_for_people(column.style, *value);
  const std::optional<Interval> interval = interval_of(column, row);
  if (!interval) return text;
  return fmt::format("{} ({}–{})", text, number_for_people(column.style, interval->low),
                     number_for_people(column.style, interval->high));
}

std::string heading(const Column& column) { return heading(column.title, column.style); }

}  // namespace pellucid::compare
