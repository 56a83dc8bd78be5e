// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/time_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/options/name_list.h"

namespace pellucid::compare {
namespace {

constexpr std::size_t fewest_for_drift = 6;

/// The seconds of each loop by when it was: rows that were measured in turn share theirs.
std::vector<double> loops_by_time(std::span<const ResultRow> rows) {
  std::map<double, double> by_time;
  for (const ResultRow& row : rows)
    for (const Calibration& c : row.calibrations) by_time[c.at] = c.seconds;
  std::vector<double> seconds;
  for (const auto& [at, s] : by_time) seconds.push_back(s);
  return seconds;
}

/// Returns the seconds below which a tenth of the loops are: the least alone may be a stray one.
double best_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 10];
}

std::vector<std::string> names_where(std::span<const ResultRow> rows,
                                     const std::function<bool(const ResultRow&)>& holds) {
  std::vector<std::string> names;
  for (const ResultRow& row : rows)
    if (row.error.empty() && holds(row)) names.push_back(row.scene + '/' + row.call());
  return names;
}

void add_disturbed(std::span<const ResultRow> rows, const std::vector<double>& loops,
                   std::vector<std::string>& warnings) {
  const double best = best_of(loops), worst = *std::max_element(loops.begin(), loops.end());
  const auto disturbed = names_where(rows, [&](const ResultRow& row) {
    return std::ranges::any_of(row.calibrations, [&](const Calibration& c) {
      return c.seconds > (1 + disturbed_by) * best;
    });
  });
  if (!disturbed.empty())
    warnings.push_back(fmt::format(
        "The machine was disturbed: a loop of fixed arithmetic, {:.1f} ms at its best, took up to "
        "{:.1f} ms beside {} of {} rows ({}); their times may be too long.",
        1e3 * best, 1e3 * worst, disturbed.size(), rows.size(), some_of(disturbed)));
}

void add_drift(const std::vector<double>& loops, std::vector<std::string>& warnings) {
  if (loops.size() < fewest_for_drift) return;
  const auto third = long(loops.size() / 3);
  const double first = median_of({loops.begin(), loops.begin() + third});
  const double last = median_of({loops.end() - third, loops.end()});
  const double change = last / first - 1;
  if (std::abs(change) >= drifted_by)
    warnings.push_back(fmt::format(
        "The machine drifted: a loop of fixed arithmetic took {:.0f} % {} at the end than at the "
        "start, so that times of cells far apart do not compare.",
        100 * std::abs(change), change > 0 ? "longer" : "shorter"));
}

void add_unsettled(std::span<const ResultRow> rows, std::vector<std::string>& warnings) {
  const auto open = names_where(rows, [](const ResultRow& row) { return row.settled == false; });
  if (!open.empty())
    warnings.push_back(
        fmt::format("{} of {} rows reached the most repeats, or the seconds, that `timing` allows "
                    "before the interval of their time was as narrow as it asks: {}.",
                    open.size(), rows.size(), some_of(open)));
}

}  // namespace

std::vector<std::string> time_warnings(std::span<const ResultRow> rows) {
  std::vector<std::string> warnings;
  if (const std::vector<double> loops = loops_by_time(rows); !loops.empty()) {
    add_disturbed(rows, loops, warnings);
    add_drift(loops, warnings);
  }
  add_unsettled(rows, warnings);
  return warnings;
}

}  // namespace pellucid::compare
