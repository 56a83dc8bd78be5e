// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/plots/plot_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/figure/figure_rows.h"
#include "compare/report/tables.h"
#include "compare/results/measure_columns.h"
#include "core/error.h"
#include "core/options/names.h"
#include "core/options/parameters.h"

namespace pellucid::compare {
namespace {

using Rows = std::vector<ResultRow>;

/// The rows of a scene that are there; named ones have to be.
Rows rows_of(const PastRun& run, const PlotRequest& request, const std::string& scene) {
  Rows rows;
  if (request.methods.empty()) {
    for (const ResultRow& row : run.rows)
      if (row.scene == scene && row.error.empty()) rows.push_back(row);
    return rows;
  }
  FigureRequest named;
  named.scenes = {scene};
  named.methods = request.methods;
  return find_figure_rows(run, named).front().rows;
}

std::vector<std::string> scenes_of(const PastRun& run, const PlotRequest& request) {
  std::vector<std::string> known;
  for (const ResultRow& row : run.rows)
    if (std::ranges::find(known, row.scene) == known.end()) known.push_back(row.scene);
  for (const std::string& scene : request.scenes)
    if (std::ranges::find(known, scene) == known.end())
      throw InputError(
          "--scene: " +
          unknown_name("scene", scene, std::vector<std::string_view>(known.begin(), known.end())));
  return request.scenes.empty() ? known : request.scenes;
}

std::optional<double> number_of(const Column& column, const ResultRow& row) {
  const std::optional<double> value = column.value(row);
  if (!value || !std::isfinite(*value)) return std::nullopt;
  return in_unit_for_people(column.style, *value);
}

PlotAxis axis_of(const Column& column, bool logarithmic) {
  const bool is_error = column.style == NumberStyle::scientific;
  return {heading(column), logarithmic, is_error ? smallest_error : 0};
}

PlotSeries& series_of(const std::string& label, PlotPanel& panel) {
  const auto found = std::ranges::find(panel.series, label, &PlotSeries::label);
  return found == panel.series.end() ? panel.series.emplace_back(PlotSeries{label, {}}) : *found;
}

/// Those that no other beats in both, ascending in x. Errors that a float's rounding makes are one.
std::vector<Vec2> front_of(const PlotPanel& panel, const Column& x, const Column& y) {
  std::vector<Vec2> points, front;
  for (const PlotSeries& series : panel.series)
    points.insert(points.end(), series.points.begin(), series.points.end());
  const bool lower = y.better != Better::higher;
  const auto worth = [&](const Vec2& p) { return lower ? std::max(p.y, smallest_error) : -p.y; };
  std::ranges::sort(points, [&](const Vec2& a, const Vec2& b) {
    return std::pair(a.x, worth(a)) < std::pair(b.x, worth(b));
  });
  if (x.better == Better::higher) return {};
  for (const Vec2& point : points)
    if (front.empty() || worth(point) < worth(front.back())) front.push_back(point);
  return front;
}

Plot trade_off(const PastRun& run, const PlotRequest& request) {
  const Column x = column_named(request.x, run.rows), y = column_named(request.y, run.rows);
  Plot plot{axis_of(x, true), axis_of(y, y.style == NumberStyle::scientific), {}, ""};
  for (const std::string& scene : scenes_of(run, request)) {
    PlotPanel panel{scene, {}, {}, {}};
    for (const ResultRow& row : rows_of(run, request, scene)) {
      const auto cost = number_of(x, row), error = number_of(y, row);
      if (cost && row.reference) {
        panel.verticals.push_back(*cost);
        plot.of_verticals = row.call() + ", the reference";
      } else if (cost && error) {
        series_of(row.method, panel).points.emplace_back(*cost, *error);
      }
    }
    panel.front = front_of(panel, x, y);
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

/// The parameter in which rows differ.
std::string varied_parameter(const std::string& method, const Rows& rows) {
  std::set<std::string> varied;
  for (const auto& [name, value] : rows.front().parameter_values)
    for (const ResultRow& row : rows)
      if (const auto other = row.parameter_values.find(name);
          other == row.parameter_values.end() || other->second != value)
        varied.insert(name);
  if (varied.size() == 1) return *varied.begin();
  throw InputError(
      fmt::format("--plot sweep:{}: its calls differ in {} parameters; accepted: in one, as of "
                  "those that --methods names",
                  method, varied.size()));
}

double swept_value(const ResultRow& row, const std::string& parameter) {
  double value = 0;
  const std::string& text = row.parameter_values.at(parameter);
  if (!parse_number(text, value))
    throw InputError(fmt::format("--plot: {}={} is no number; accepted: a parameter of numbers",
                                 parameter, text));
  return value;
}

Plot sweep(const PastRun& run, const PlotRequest& request, const std::string& method) {
  const Column y = column_named(request.y, run.rows);
  Plot plot{{"", request.logarithmic_x}, axis_of(y, request.logarithmic_y), {}, ""};
  for (const std::string& scene : scenes_of(run, request)) {
    Rows rows = rows_of(run, request, scene);
    std::erase_if(rows, [&](const ResultRow& row) {
      return row.reference || row.method != method || !number_of(y, row);
    });
    if (rows.size() < 2)
      throw InputError(fmt::format(
          "--plot sweep:{}: {} has {} of its calls with a number; accepted: two or more", method,
          scene, rows.size()));
    plot.x.title = varied_parameter(method, rows);
    PlotPanel panel{scene, {{method, {}, true}}, {}, {}};
    for (const ResultRow& row : rows)
      panel.series[0].points.emplace_back(swept_value(row, plot.x.title), *number_of(y, row));
    std::ranges::sort(panel.series[0].points, {}, &Vec2::x);
    plot.panels.push_back(std::move(panel));
  }
  return plot;
}

Plot curves(const PastRun& run, const PlotRequest& request, const std::string& name) {
  Plot plot{{"", request.logarithmic_x}, {"", request.logarithmic_y}, {}, ""};
  std::vector<std::string_view> known;
  for (const ResultRow& row : run.rows)
    for (const RowCurve& curve : row.curves)
      if (std::ranges::find(known, curve.name) == known.end()) known.push_back(curve.name);
  if (std::ranges::find(known, name) == known.end())
    throw InputError("--plot: " + unknown_name("curve", name, known));
  for (const std::string& scene : scenes_of(run, request)) {
    PlotPanel panel{scene, {}, {}, {}};
    for (const ResultRow& row : rows_of(run, request, scene))
      for (const RowCurve& curve : row.curves) {
        if (curve.name != name) continue;
        plot.x.title = curve.x_title;
        plot.y.title = curve.y_title;
        PlotSeries series{curve.label.empty() ? row.call() : curve.label, {}, true};
        for (std::size_t i = 0; i < curve.x.size(); ++i)
          if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
            series.points.emplace_back(curve.x[i], curve.y[i]);
        panel.series.push_back(std::move(series));
      }
    if (!panel.series.empty()) plot.panels.push_back(std::move(panel));
  }
  return plot;
}

struct PlotKind {
  std::string_view prefix;
  Plot (*read)(const PastRun&, const PlotRequest&, const std::string& of);
};

constexpr PlotKind kinds[] = {{"sweep:", sweep}, {"curves:", curves}};

bool has_points(const Plot& plot) {
  return std::ranges::any_of(plot.panels, [](const PlotPanel& panel) {
    return std::ranges::any_of(panel.series,
                               [](const PlotSeries& series) { return !series.points.empty(); });
  });
}

Plot read_kind(const PastRun& run, const PlotRequest& request) {
  if (request.kind == "trade-off") return trade_off(run, request);
  for (const PlotKind& kind : kinds)
    if (request.kind.starts_with(kind.prefix))
      return kind.read(run, request, request.kind.substr(kind.prefix.size()));
  throw InputError(
      fmt::format("--plot: '{}'; accepted: trade-off, sweep:METHOD, curves:NAME", request.kind));
}

}  // namespace

Plot read_plot(const PastRun& run, const PlotRequest& request) {
  Plot plot = read_kind(run, request);
  if (!has_points(plot))
    throw InputError(
        fmt::format("--plot {}: no row has its numbers; accepted: scenes and methods "
                    "that do",
                    request.kind));
  return plot;
}

std::string csv_of(const Plot& plot) {
  std::string text =
      fmt::format("scene,label,{},{}\n", csv_field(plot.x.title), csv_field(plot.y.title));
  for (const PlotPanel& panel : plot.panels)
    for (const PlotSeries& series : panel.series)
      for (const Vec2& point : series.points)
        text += fmt::format("{},{},{},{}\n", csv_field(panel.title), csv_field(series.label),
                            csv_digits(point.x), csv_digits(point.y));
  return text;
}

}  // namespace pellucid::compare
