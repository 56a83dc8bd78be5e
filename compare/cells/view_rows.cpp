// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/cells/view_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

#include "compare/cells/ray_curves.h"
#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

using Rows = std::vector<ResultRow>;

Image difference(const Image& reference, const Image& test) {
  Image error = test;
  for (std::size_t i = 0; i < error.pixels.size(); ++i) error.pixels[i] -= reference.pixels[i];
  return error;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The numbers of all rows; nothing where one lacks it.
std::optional<std::vector<double>> all_of(
    const Rows& rows, const std::function<std::optional<double>(const ResultRow&)>& number) {
  std::vector<double> numbers;
  for (const ResultRow& row : rows) {
    const std::optional<double> value = number(row);
    if (!value) return std::nullopt;
    numbers.push_back(*value);
  }
  return numbers;
}

std::optional<double> mean_of(
    const Rows& rows, const std::function<std::optional<double>(const ResultRow&)>& number) {
  const auto numbers = all_of(rows, number);
  return numbers ? std::optional(mean(*numbers)) : std::nullopt;
}

/// The mean of those that are finite: the PSNR of equal pictures is infinite, and one such view
/// would hide what all others are like.
std::optional<double> mean_metric(
    const Rows& rows, const std::function<std::optional<double>(const ResultRow&)>& number) {
  auto numbers = all_of(rows, number);
  if (!numbers) return std::nullopt;
  if (std::ranges::any_of(*numbers, [](double x) { return std::isfinite(x); }))
    std::erase_if(*numbers, [](double x) { return std::isinf(x); });
  return mean(*numbers);
}

/// Of whole numbers the mean, rounded up: of what is lost in any view something is left.
template <class Number>
std::uint64_t mean_count(const Rows& rows, Number number) {
  return std::uint64_t(std::ceil(
      *mean_of(rows, [&](const ResultRow& row) { return std::optional(double(number(row))); })));
}

Metrics mean_metrics(const Rows& rows, Metrics Comparison::*which) {
  Metrics means = rows.front().metrics.*which;
  for (std::size_t m = 0; m < metrics().size(); ++m)
    means[m] = mean_metric(rows, [&](const ResultRow& row) { return (row.metrics.*which)[m]; });
  means.covered = mean_of(rows, [&](const ResultRow& row) { return (row.metrics.*which).covered; });
  const ResultRow& worst = *std::ranges::max_element(rows, {}, [&](const ResultRow& row) {
    return (row.metrics.*which).of("max_error").value_or(0);
  });
  means.max_error_x = (worst.metrics.*which).max_error_x;
  means.max_error_y = (worst.metrics.*which).max_error_y;
  return means;
}

using IntervalOf = std::function<std::optional<Interval>(const ResultRow&)>;

/// Ends are means, too, which makes an interval no narrower than one of 95 %; nothing where one row
/// has none.
std::optional<Interval> mean_interval(const Rows& rows, const IntervalOf& interval_of) {
  const auto mean_end = [&](double Interval::*end) {
    return mean_of(rows, [&](const ResultRow& row) {
      const std::optional<Interval> interval = interval_of(row);
      return interval ? std::optional((*interval).*end) : std::nullopt;
    });
  };
  const std::optional<double> low = mean_end(&Interval::low), high = mean_end(&Interval::high);
  return low && high ? std::optional(Interval{*low, *high}) : std::nullopt;
}

/// Of the metrics of methods of random numbers.
std::map<std::string, Interval> mean_intervals(const Rows& rows) {
  std::map<std::string, Interval> means;
  for (const auto& of_first : rows.front().metric_intervals) {
    const std::string& name = of_first.first;
    const auto mean = mean_interval(rows, [&](const ResultRow& row) {
      const auto found = row.metric_intervals.find(name);
      return found == row.metric_intervals.end() ? std::nullopt : std::optional(found->second);
    });
    if (mean) means[name] = *mean;
  }
  return means;
}

using SpreadOf = std::function<const Spread&(const ResultRow&)>;

Spread mean_spread(const Rows& rows, const SpreadOf& spread_of) {
  Spread spread = spread_of(rows.front());
  for (const ResultRow& row : rows) {
    spread.min = std::min(spread.min, spread_of(row).min);
    spread.max = std::max(spread.max, spread_of(row).max);
  }
  spread.median =
      *mean_of(rows, [&](const ResultRow& row) { return std::optional(spread_of(row).median); });
  spread.interval =
      mean_interval(rows, [&](const ResultRow& row) { return spread_of(row).interval; });
  return spread;
}

void average_times(const Rows& rows, ResultRow& row) {
  const auto mean_seconds = [&](double ResultRow::*seconds) {
    return *mean_of(rows, [&](const ResultRow& r) { return std::optional(r.*seconds); });
  };
  row.seconds = mean_spread(rows, [](const ResultRow& r) -> const Spread& { return r.seconds; });
  for (std::size_t i = 0; i < row.steps.size(); ++i)
    if (std::ranges::all_of(rows, [&](const ResultRow& r) { return i < r.steps.size(); }))
      row.steps[i].second =
          mean_spread(rows, [i](const ResultRow& r) -> const Spread& { return r.steps[i].second; });
  row.setup_seconds = mean_seconds(&ResultRow::setup_seconds);
  row.first_seconds = mean_seconds(&ResultRow::first_seconds);
  row.gl_seconds = mean_of(rows, [](const ResultRow& r) { return r.gl_seconds; });
  row.repeats = int(mean_count(rows, [](const ResultRow& r) { return r.repeats; }));
  if (row.settled)
    row.settled = std::ranges::all_of(rows, [](const ResultRow& r) { return *r.settled; });
}

CoverageCheck mean_coverage(const Rows& rows) {
  CoverageCheck check = *rows.front().coverage;
  check.differing = mean_count(rows, [](const ResultRow& r) { return r.coverage->differing; });
  check.differing_by_more =
      mean_count(rows, [](const ResultRow& r) { return r.coverage->differing_by_more; });
  check.rmse_elsewhere =
      mean_of(rows, [](const ResultRow& r) { return r.coverage->rmse_elsewhere; });
  return check;
}

void average_counts(const Rows& rows, ResultRow& row) {
  row.fragments = mean_count(rows, [](const ResultRow& r) { return r.fragments; });
  row.stored = mean_count(rows, [](const ResultRow& r) { return r.stored; });
  row.dropped = mean_count(rows, [](const ResultRow& r) { return r.dropped; });
  row.truncated = mean_count(rows, [](const ResultRow& r) { return r.truncated; });
  row.max_layers = std::ranges::max(rows, {}, &ResultRow::max_layers).max_layers;
  row.bytes = std::ranges::max(rows, {}, &ResultRow::total_bytes).bytes;
  if (std::ranges::all_of(rows, [](const ResultRow& r) { return r.coverage.has_value(); }))
    row.coverage = mean_coverage(rows);
}

/// What looks wrong with a picture from elsewhere: once where it is the same from all views, else
/// with the views from which it does.
std::vector<std::string> all_faults(const Rows& rows) {
  std::vector<std::string> faults;
  std::map<std::string, std::vector<std::size_t>> views;
  for (std::size_t view = 0; view < rows.size(); ++view)
    for (const std::string& fault : rows[view].given_faults) {
      if (!views.contains(fault)) faults.push_back(fault);
      views[fault].push_back(view + 1);
    }
  for (std::string& fault : faults)
    if (const auto& seen = views[fault]; seen.size() < rows.size())
      fault = fmt::format("from view{} {} {}", seen.size() > 1 ? "s" : "", fmt::join(seen, ", "),
                          fault);
  return faults;
}

/// What a picture from elsewhere costs is only known where it is from all views, and in one way.
void forget_unknown_costs(const Rows& rows, ResultRow& row) {
  const auto steps = [](const ResultRow& r) {
    std::vector<std::string> names;
    for (const auto& [name, spread] : r.steps) names.push_back(name);
    return names;
  };
  const auto all = [&](auto holds) { return std::ranges::all_of(rows, holds); };
  if (!all([&](const ResultRow& r) { return steps(r) == steps(row); })) {
    row.steps.clear();
    row.explanation.emplace_back("its time was not taken in one way from all views: not known");
  }
  if (!all([](const ResultRow& r) { return !r.bytes.empty(); })) row.bytes.clear();
  if (!all([](const ResultRow& r) { return r.fragments > 0; })) row.fragments = 0;
}

/// A measure that some view lacks has no mean; those of probes, which are pixels of the first view,
/// are that view's.
void average_measures(const Rows& rows, ResultRow& row) {
  std::vector<scene::Measure> means;
  for (scene::Measure& measure : row.measures)
    if (is_of_probes(measure.name)) {
      means.push_back(measure);
    } else if (const auto value =
                   mean_of(rows, [&](const ResultRow& r) { return measure_of(r, measure.name); })) {
      measure.value = *value;
      means.push_back(measure);
    }
  row.measures = std::move(means);
}

/// The numbers beside them are of all views.
void say_of_which_view(std::vector<RowCurve>& curves) {
  for (RowCurve& curve : curves) curve.title += ", view 1";
}

RowCurve view_curve(const std::string& symbol, std::size_t first, std::vector<double> values) {
  RowCurve curve{
      symbol + " over the views", "", symbol + " over the views", "view", symbol, {}, {}};
  for (std::size_t i = 0; i < values.size(); ++i) curve.x.push_back(double(first + i));
  curve.y = std::move(values);
  return curve;
}

/// The PSNR of equal pictures is none.
bool is_finite(double value) { return std::isfinite(value); }

/// The worst of each metric, and the curves of those that caption a picture.
void add_metrics(const Rows& rows, ResultRow& row) {
  for (std::size_t m = 0; m < metrics().size(); ++m) {
    const MetricRow& metric = metrics()[m];
    const auto values = all_of(rows, [m](const ResultRow& r) { return r.metrics.linear[m]; });
    if (!values || metric.better == Better::neither) continue;
    const auto [least, most] = std::ranges::minmax(*values);
    row.measures.push_back({fmt::format("{}_worst", metric.name),
                            fmt::format("{}, worst view", metric.symbol), "",
                            metric.better == Better::lower ? most : least, metric.better});
    if (metric.shown.card && std::ranges::all_of(*values, is_finite))
      row.curves.push_back(view_curve(std::string(metric.symbol), 1, *values));
  }
}

}  // namespace

void ViewRows::add(ResultRow row, const Image& reference, const Image& test) {
  rows_.push_back(std::move(row));
  if (!path_) return;
  Image error = difference(reference, test);
  if (!error_.pixels.empty()) flicker_.push_back(rmse(error_, error));
  error_ = std::move(error);
}

ResultRow ViewRows::row() const {
  ResultRow row = rows_.front();
  if (rows_.size() == 1) return row;
  row.metrics = {mean_metrics(rows_, &Comparison::linear),
                 mean_metrics(rows_, &Comparison::displayed)};
  row.metric_intervals = mean_intervals(rows_);
  average_times(rows_, row);
  average_counts(rows_, row);
  average_measures(rows_, row);
  row.given_faults = all_faults(rows_);
  if (!row.given.empty()) forget_unknown_costs(rows_, row);
  row.measures.push_back({"views", "Views", "", double(rows_.size()), Better::neither});
  say_of_which_view(row.curves);
  add_metrics(rows_, row);
  if (flicker_.empty()) return row;
  row.measures.push_back({"flicker", "Flicker", "", mean(flicker_), Better::lower});
  row.curves.push_back(view_curve("Flicker", 2, flicker_));
  return row;
}

}  // namespace pellucid::compare
