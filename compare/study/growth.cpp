// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

namespace pellucid::compare {
namespace {

using Points = std::vector<std::pair<double, double>>;

/// The logarithms of the points that have them, by ascending x.
Points logarithms(std::span<const std::pair<double, double>> points) {
  Points logs;
  for (const auto& [x, y] : points)
    if (x > 0 && y > 0 && std::isfinite(x) && std::isfinite(y))
      logs.emplace_back(std::log(x), std::log(y));
  std::ranges::sort(logs);
  return logs;
}

double slope(const std::pair<double, double>& a, const std::pair<double, double>& b) {
  return (b.second - a.second) / (b.first - a.first);
}

/// A line by least squares.
struct Line {
  double at_mean = 0, mean = 0, slope = 0;
  double squares = 0;  // Σ (x - mean)²

  explicit Line(const Points& points) {
    const auto n = double(points.size());
    for (const auto& [x, y] : points) {
      mean += x / n;
      at_mean += y / n;
    }
    double products = 0;
    for (const auto& [x, y] : points) {
      squares += (x - mean) * (x - mean);
      products += (x - mean) * (y - at_mean);
    }
    slope = products / squares;
  }
  double residual(const std::pair<double, double>& p) const {
    return p.second - at_mean - slope * (p.first - mean);
  }
};

/// slope ± t s / √Σ (x - mean)², with s² = Σ residual² / (n - 2) and t of n - 2 degrees of freedom.
Interval interval_of_slope(const Line& line, const Points& points) {
  const double freedom = double(points.size()) - 2;
  double squares = 0;
  for (const auto& point : points) squares += line.residual(point) * line.residual(point);
  const double t =
      boost::math::quantile(boost::math::students_t(freedom), 0.5 + usual_confidence / 2);
  const double half = t * std::sqrt(squares / freedom / line.squares);
  return {line.slope - half, line.slope + half};
}

}  // namespace

std::optional<PowerLaw> power_law(std::span<const std::pair<double, double>> points) {
  const Points logs = logarithms(points);
  if (logs.size() < 2 || logs.front().first == logs.back().first) return std::nullopt;
  const auto before = std::ranges::find_if(logs.rbegin(), logs.rend(), [&](const auto& point) {
    return point.first < logs.back().first;
  });
  const Line line(logs);
  PowerLaw law{line.slope, std::nullopt, slope(*before, logs.back())};
  if (logs.size() > 2) law.interval = interval_of_slope(line, logs);
  return law;
}

std::vector<GrowthCurve> growth_curves(const Growth& growth, const Column& column,
                                       std::span<const ResultRow> rows) {
  std::vector<GrowthCurve> curves;
  for (const ResultRow& of_call : rows) {
    const std::string call = of_call.call();
    if (std::ranges::find(curves, call, &GrowthCurve::call) != curves.end()) continue;
    GrowthCurve curve{call, {}, {}};
    for (const auto& [scene, size] : growth.scenes)
      if (const ResultRow* row = row_of_cell(scene, call, rows); row && row->error.empty())
        if (const auto value = column.value(*row)) curve.points.emplace_back(size, *value);
    if (curve.points.empty()) continue;
    std::ranges::sort(curve.points);
    curve.law = power_law(curve.points);
    curves.push_back(std::move(curve));
  }
  return curves;
}

std::string text_of(const std::optional<PowerLaw>& law) {
  if (!law) return "–";
  std::string text = fmt::format("{:.2f}", law->exponent);
  if (law->interval)
    text += fmt::format(" ({:.2f}–{:.2f})", law->interval->low, law->interval->high);
  return text + fmt::format(", last {:.2f}", law->last_exponent);
}

}  // namespace pellucid::compare
