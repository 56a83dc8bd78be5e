// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/result_row.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "compare/results/number_json.h"

namespace pellucid::compare {
namespace {

using nlohmann::json;

/// Of the numbers over the whole picture, a missing one is null; of all others it is left out.
json metrics_json(const Metrics& m, bool displayed = false) {
  json j;
  for (std::size_t i = 0; i < metrics().size(); ++i) {
    const MetricRow& row = metrics()[i];
    const bool expected =
        !row.on_request && row.region == Region::all && row.displayed >= displayed;
    if (m[i] || expected) j[std::string(row.name)] = number_json(m[i]);
  }
  if (m.covered && !displayed) j["covered"] = *m.covered;
  j["max_error_pixel"] = {m.max_error_x, m.max_error_y};
  return j;
}

/// A metric that a row of an earlier build does not have is missing.
Metrics metrics_from(const json& j) {
  Metrics m;
  for (std::size_t row = 0; row < metrics().size(); ++row) {
    const MetricRow& metric = metrics()[row];
    const auto found = j.find(metric.name);
    if (found == j.end()) continue;
    m[row] = number_of(*found);
    // As builds before this one wrote it.
    if (!m[row] && metric.infinite_when_equal) m[row] = std::numeric_limits<double>::infinity();
  }
  if (j.contains("covered")) m.covered = j.at("covered").get<double>();
  m.max_error_x = j.at("max_error_pixel").at(0);
  m.max_error_y = j.at("max_error_pixel").at(1);
  return m;
}

json metric_intervals_json(const ResultRow& row) {
  json j = json::object();
  for (const auto& [name, interval] : row.metric_intervals)
    j[name] = {number_json(interval.low), number_json(interval.high)};
  return j;
}

void metric_intervals_from(const json& j, ResultRow& row) {
  for (const auto& [name, ends] : j.items())
    row.metric_intervals[name] = {number_of(ends.at(0)).value(), number_of(ends.at(1)).value()};
}

json spread_json(const Spread& s) {
  json j{{"median", s.median}, {"min", s.min}, {"max", s.max}};
  if (s.interval) j["interval"] = {s.interval->low, s.interval->high};
  return j;
}

Spread spread_from(const json& j) {
  const auto number = [&](const char* key) {
    return j.at(key).is_null() ? 0 : j.at(key).get<double>();
  };
  Spread spread{number("median"), number("min"), number("max")};
  if (j.contains("interval")) spread.interval = {j["interval"].at(0), j["interval"].at(1)};
  return spread;
}

json calibrations_json(const ResultRow& row) {
  json list = json::array();
  for (const Calibration& c : row.calibrations)
    list.push_back({{"at", c.at}, {"seconds", c.seconds}});
  return list;
}

json seconds_json(const ResultRow& row) {
  json steps = json::array();  // in the order in which they run
  for (const auto& [name, spread] : row.steps) {
    steps.push_back(spread_json(spread));
    steps.back()["name"] = name;
  }
  json seconds = spread_json(row.seconds);
  if (!row.given.empty() && row.steps.empty())  // which nobody told
    for (const char* key : {"median", "min", "max"}) seconds[key] = nullptr;
  seconds["steps"] = steps;
  seconds["setup"] = row.setup_seconds;
  seconds["first"] = row.first_seconds;
  seconds["calibrations"] = calibrations_json(row);
  if (row.gl_seconds) seconds["gl"] = *row.gl_seconds;
  if (row.settled) seconds["settled"] = *row.settled;
  seconds["repeats"] = row.repeats;
  return seconds;
}

void seconds_from(const json& j, ResultRow& row) {
  row.seconds = spread_from(j);
  for (const json& step : j.at("steps")) row.steps.emplace_back(step.at("name"), spread_from(step));
  row.setup_seconds = j.at("setup");
  row.first_seconds = j.at("first");
  for (const json& c : j.at("calibrations"))
    row.calibrations.push_back({c.at("at"), c.at("seconds")});
  if (j.contains("gl")) row.gl_seconds = j["gl"].get<double>();
  if (j.contains("settled")) row.settled = j["settled"].get<bool>();
  row.repeats = j.at("repeats");
}

json bytes_json(const ResultRow& row) {
  json parts = json::array();
  for (const scene::NamedBytes& part : row.bytes)
    parts.push_back({{"name", part.name}, {"bytes", part.bytes}});
  const bool is_known = row.given.empty() || !row.bytes.empty();
  return {{"total", is_known ? json(row.total_bytes()) : json()}, {"parts", parts}};
}

json coverage_json(const CoverageCheck& c) {
  return {{"layers_differ", c.differing},
          {"layers_differ_by_more", c.differing_by_more},
          {"pixels", c.pixels},
          {"rmse_equal_layers", number_json(c.rmse_elsewhere)}};
}

CoverageCheck coverage_from(const json& j) {
  return {j.at("layers_differ"), j.at("layers_differ_by_more"), j.at("pixels"),
          number_of(j.at("rmse_equal_layers"))};
}

json measures_json(const ResultRow& row) {
  json list = json::array();
  for (const scene::Measure& m : row.measures)
    list.push_back({{"name", m.name},
                    {"title", m.title},
                    {"unit", m.unit},
                    {"value", number_json(m.value)},
                    {"better", name_of(m.better)}});
  return list;
}

/// An option may be infinite (ε² of the tree) and then is a measure; null is how builds before this
/// one wrote it.
scene::Measure measure_from(const json& j) {
  return {j.at("name"), j.at("title"), j.at("unit"),
          number_of(j.at("value")).value_or(std::numeric_limits<double>::infinity()),
          better_of_name(j.at("better").get<std::string_view>())};
}

json pictures_json(const ResultRow& row) {
  json list = json::array();
  for (const RowPicture& p : row.pictures)
    list.push_back({{"name", p.name}, {"title", p.title}, {"min", p.min}, {"max", p.max}});
  return list;
}

json curves_json(const ResultRow& row) {
  json list = json::array();
  for (const RowCurve& c : row.curves)
    list.push_back({{"name", c.name},
                    {"label", c.label},
                    {"title", c.title},
                    {"x_title", c.x_title},
                    {"y_title", c.y_title},
                    {"x", c.x},
                    {"y", c.y}});
  return list;
}

void add_results(const ResultRow& row, json& j) {
  j["metrics"] = to_json(row.metrics);
  if (!row.metric_intervals.empty()) j["metric_intervals"] = metric_intervals_json(row);
  j["seconds"] = seconds_json(row);
  j["bytes"] = bytes_json(row);
  // Of a picture from elsewhere only what its maker told is known.
  const bool is_own = row.given.empty();
  j["fragments"] = is_own || row.fragments > 0 ? json(row.fragments) : json();
  j["stored"] = row.stored;
  j["dropped"] = row.dropped;
  j["truncated_pixels"] = row.truncated;
  j["max_layers"] = is_own ? json(row.max_layers) : json();
  if (row.coverage) j["coverage"] = coverage_json(*row.coverage);
  if (!row.given.empty()) j["faults"] = row.given_faults;
  j["measures"] = measures_json(row);
  j["pictures"] = pictures_json(row);
  j["curves"] = curves_json(row);
  if (row.budget) j["budget"] = to_json(*row.budget);
  j["explanation"] = row.explanation;
  j["scene_provenance"] = row.scene_provenance;
}

void results_from(const json& j, ResultRow& row) {
  row.metrics = {metrics_from(j.at("metrics")), metrics_from(j.at("metrics").at("displayed"))};
  if (j.contains("metric_intervals")) metric_intervals_from(j["metric_intervals"], row);
  seconds_from(j.at("seconds"), row);
  for (const json& part : j.at("bytes").at("parts"))
    row.bytes.push_back({part.at("name"), part.at("bytes")});
  row.fragments = j.at("fragments").is_null() ? 0 : j.at("fragments").get<std::uint64_t>();
  row.stored = j.at("stored");
  row.dropped = j.at("dropped");
  row.truncated = j.at("truncated_pixels");
  row.max_layers = j.at("max_layers").is_null() ? 0 : j.at("max_layers").get<std::uint32_t>();
  if (j.contains("coverage")) row.coverage = coverage_from(j.at("coverage"));
  if (j.contains("faults")) row.given_faults = j.at("faults");
  for (const json& measure : j.at("measures")) row.measures.push_back(measure_from(measure));
  for (const json& p : j.at("pictures"))
    row.pictures.push_back({p.at("name"), p.at("title"), p.at("min"), p.at("max")});
  for (const json& c : j.at("curves"))
    row.curves.push_back({c.at("name"), c.at("label"), c.at("title"), c.at("x_title"),
                          c.at("y_title"), c.at("x"), c.at("y")});
  if (j.contains("budget")) row.budget = budget_from_json(j.at("budget"));
  row.explanation = j.at("explanation");
  row.scene_provenance = j.at("scene_provenance");
}

}  // namespace

std::uint64_t ResultRow::total_bytes() const {
  std::uint64_t sum = 0;
  for (const scene::NamedBytes& part : bytes) sum += part.bytes;
  return sum;
}

const ResultRow* row_of_cell(const std::string& scene, const std::string& call,
                             std::span<const ResultRow> rows) {
  const auto found = std::ranges::find_if(
      rows, [&](const ResultRow& row) { return row.scene == scene && row.call() == call; });
  return found == rows.end() ? nullptr : &*found;
}

json to_json(const Comparison& comparison) {
  json j = metrics_json(comparison.linear);
  j["displayed"] = metrics_json(comparison.displayed, true);
  return j;
}

json to_json(const ResultRow& row) {
  json j = {{"scene", row.scene},           {"method", row.method},
            {"parameters", row.parameters}, {"parameter_values", row.parameter_values},
            {"reference", row.reference},   {"fingerprint", row.fingerprint},
            {"files_read", row.files_read}, {"machine", row.machine}};
  if (!row.given.empty()) j["given"] = row.given;
  if (row.error.empty())
    add_results(row, j);
  else
    j["error"] = row.error;
  return j;
}

ResultRow row_from_json(const json& j) {
  ResultRow row;
  row.scene = j.at("scene");
  row.method = j.at("method");
  row.parameters = j.at("parameters");
  for (const auto& item : j.at("parameter_values").items())
    row.parameter_values.emplace(item.key(), item.value());
  row.reference = j.at("reference");
  row.fingerprint = j.at("fingerprint");
  row.files_read = j.at("files_read");
  row.machine = j.at("machine");
  row.error = j.value("error", "");
  row.given = j.value("given", "");
  if (row.error.empty()) results_from(j, row);
  return row;
}

}  // namespace pellucid::compare
