// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/changes/number_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/results/columns.h"
#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

/// What depends on the machine: how long it takes, and how many threads have memory of their own.
bool is_cost(const Column& column) { return is_time(column) || column.unit == "bytes"; }

/// Threads that had no part of a picture have no memory: which ones do differs from run to run, by
/// some hundred KiB each.
double rounding_of_bytes(double a, double b) { return 0x1p20 + 0.1 * std::max(a, b); }

/// What says the same again of a picture, or of an interval's ends.
bool is_repeated(const Column& column) {
  return column.name == "psnr" || column.name.ends_with("_8bit") || column.name == "ms";
}

/// FLIP raises differences of colour to the power 0.7: 2^-20 becomes 6e-5.
constexpr double rounding_of_flip = 1e-4;

double rounding_of(const Column& column) {
  if (column.name.starts_with("flip")) return rounding_of_flip;
  return rounding_of_picture;
}

/// Counts are whole and below 2^53; half of one is none.
bool is_count(const Column& column) {
  return column.style == NumberStyle::count || column.style == NumberStyle::megabytes;
}

/// The least and the longest of few times stand in for the interval that they do not have.
std::optional<Interval> spread_of_time(const Column& column, const ResultRow& row) {
  if (const auto interval = interval_of(column, row)) return interval;
  if (row.repeats < 2) return std::nullopt;
  return Interval{row.seconds.min, row.seconds.max};
}

bool times_part(const Column& column, const ResultRow& a, const ResultRow& b) {
  if (column.name != "seconds") return false;
  const auto of_a = spread_of_time(column, a), of_b = spread_of_time(column, b);
  return of_a && of_b && !overlap(*of_a, *of_b);
}

bool differ(double a, double b, double within) {
  if (std::isnan(a) || std::isnan(b)) return std::isnan(a) != std::isnan(b);
  return a != b && !(std::abs(a - b) <= within);
}

bool is_changed(const Column& column, const ResultRow& a, const ResultRow& b) {
  const std::optional<double> of_a = column.value(a), of_b = column.value(b);
  if (is_time(column)) return of_a && of_b && times_part(column, a, b);
  if (is_repeated(column)) return false;
  if (of_a.has_value() != of_b.has_value()) return true;
  if (!of_a) return false;
  if (column.unit == "bytes") return differ(*of_a, *of_b, rounding_of_bytes(*of_a, *of_b));
  return differ(*of_a, *of_b, is_count(column) ? 0.5 : rounding_of(column));
}

NumberChange change_of(const Column& column, const ResultRow& a, const ResultRow& b) {
  NumberChange change{heading(column), text_with_interval(column, a), text_with_interval(column, b),
                      is_cost(column)};
  const std::optional<double> of_a = column.value(a), of_b = column.value(b);
  if (column.better != Better::neither && of_a && of_b)
    change.better = is_better(column, *of_b, *of_a);
  return change;
}

std::string text_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.9g}", *value) : "–";
}

/// The worst of a metric over views is held to what the metric is. Measures of a method's own have
/// no common range: theirs is relative.
bool is_changed(const scene::Measure& m, const std::optional<double>& a,
                const std::optional<double>& b) {
  if (is_of_time(m)) return false;
  if (a.has_value() != b.has_value()) return true;
  if (!a || m.name == "psnr_worst") return false;
  if (m.name == "flip_worst" || m.name == "flip_covered_worst")
    return differ(*a, *b, rounding_of_flip);
  if (m.name.ends_with("_worst") || m.name == "flicker") return differ(*a, *b, rounding_of_picture);
  return differ(*a, *b, rounding_of_picture * std::max(std::abs(*a), std::abs(*b)));
}

/// A share is of the whole error's square: the smaller that is, the more a rounding tells.
void add_budget(const ResultRow& a, const ResultRow& b, std::vector<NumberChange>& changes) {
  if (!a.budget || !b.budget) return;
  const double smaller = std::min(a.budget->rmse, b.budget->rmse);
  const double rounding = smaller > 0 ? rounding_of_picture / smaller : 0;
  for (const BudgetLine& line : a.budget->lines) {
    const auto other = std::ranges::find(b.budget->lines, line.stage, &BudgetLine::stage);
    if (other == b.budget->lines.end() || !line.why_not.empty() || !other->why_not.empty() ||
        !differ(line.share, other->share, rounding))
      continue;
    changes.push_back({fmt::format("Share of '{}' in the error", line.stage), text_of(line.share),
                       text_of(other->share)});
  }
}

void add_measures(const ResultRow& a, const ResultRow& b, std::vector<NumberChange>& changes) {
  for (const scene::Measure& m : measure_columns(std::vector{a, b})) {
    const std::optional<double> of_a = measure_of(a, m.name), of_b = measure_of(b, m.name);
    if (!is_changed(m, of_a, of_b)) continue;
    NumberChange change{heading(m), text_of(of_a), text_of(of_b)};
    if (m.better != Better::neither && of_a && of_b)
      change.better = m.better == Better::lower ? *of_b < *of_a : *of_b > *of_a;
    changes.push_back(std::move(change));
  }
}

}  // namespace

std::vector<NumberChange> number_changes(const ResultRow& before, const ResultRow& after) {
  std::vector<NumberChange> changes;
  for (const Column& column : columns())
    if (column.name != "repeats" && is_changed(column, before, after))
      changes.push_back(change_of(column, before, after));
  add_measures(before, after, changes);
  add_budget(before, after, changes);
  return changes;
}

}  // namespace pellucid::compare
