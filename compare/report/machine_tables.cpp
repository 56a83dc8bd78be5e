// SPDX-License-Identifier: GPL-3.0-or-later
// The tables for programs: CSV and JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "compare/report/tables.h"
#include "compare/results/measure_columns.h"

namespace pellucid::compare {
namespace {

/// Shortest text that reads back as the same double; "inf" for the PSNR of equal pictures.
std::string digits(std::optional<double> value) { return value ? fmt::format("{}", *value) : ""; }

struct CsvColumn {
  std::string_view name;
  std::string (*text)(const ResultRow&);
};

std::string differing_layers(const ResultRow& r) {
  return r.coverage ? fmt::format("{}", r.coverage->differing) : "";
}

std::string rmse_equal_layers(const ResultRow& r) {
  return r.coverage ? digits(r.coverage->rmse_elsewhere) : "";
}

constexpr CsvColumn identity_columns[] = {
    {"scene", [](const ResultRow& r) { return r.scene; }},
    {"method", [](const ResultRow& r) { return r.method; }},
    {"parameters", [](const ResultRow& r) { return r.parameters; }}};

constexpr CsvColumn result_columns[] = {
    {"rmse", [](const ResultRow& r) { return digits(r.metrics.linear.rmse); }},
    {"ssim", [](const ResultRow& r) { return digits(r.metrics.linear.ssim); }},
    {"psnr", [](const ResultRow& r) { return digits(r.metrics.linear.psnr); }},
    {"seconds", [](const ResultRow& r) { return digits(r.seconds.median); }},
    {"bytes", [](const ResultRow& r) { return fmt::format("{}", r.total_bytes()); }},
    {"fragments", [](const ResultRow& r) { return fmt::format("{}", r.fragments); }},
    {"max_layers", [](const ResultRow& r) { return fmt::format("{}", r.max_layers); }},
    {"max_error", [](const ResultRow& r) { return digits(r.metrics.linear.max_error.value); }},
    {"rmse_8bit", [](const ResultRow& r) { return digits(r.metrics.displayed.rmse); }},
    {"ssim_8bit", [](const ResultRow& r) { return digits(r.metrics.displayed.ssim); }},
    {"psnr_8bit", [](const ResultRow& r) { return digits(r.metrics.displayed.psnr); }},
    {"max_error_8bit",
     [](const ResultRow& r) { return digits(r.metrics.displayed.max_error.value); }},
    {"seconds_min", [](const ResultRow& r) { return digits(r.seconds.min); }},
    {"seconds_max", [](const ResultRow& r) { return digits(r.seconds.max); }},
    {"setup_seconds", [](const ResultRow& r) { return digits(r.setup_seconds); }},
    {"dropped", [](const ResultRow& r) { return fmt::format("{}", r.dropped); }},
    {"stored", [](const ResultRow& r) { return fmt::format("{}", r.stored); }},
    {"truncated_pixels", [](const ResultRow& r) { return fmt::format("{}", r.truncated); }},
    {"layers_differ", differing_layers},
    {"rmse_equal_layers", rmse_equal_layers}};

/// Quoted when it has to be.
std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_header(std::span<const scene::Measure> measures) {
  std::string line;
  for (const CsvColumn& column : identity_columns) line += fmt::format("{},", column.name);
  for (const CsvColumn& column : result_columns) line += fmt::format("{},", column.name);
  for (const scene::Measure& measure : measures) line += csv_field(measure.name) + ',';
  return line + "error\n";
}

std::string csv_line(const ResultRow& row, std::span<const scene::Measure> measures) {
  std::string line;
  for (const CsvColumn& column : identity_columns) line += csv_field(column.text(row)) + ',';
  for (const CsvColumn& column : result_columns)
    line += (row.error.empty() ? csv_field(column.text(row)) : "") + ',';
  for (const scene::Measure& measure : measures)
    line += digits(measure_of(row, measure.name)) + ',';
  return line + csv_field(row.error) + '\n';
}

}  // namespace

std::string csv_table(std::span<const ResultRow> rows) {
  const std::vector<scene::Measure> measures = measure_columns(rows);
  std::string text = csv_header(measures);
  for (const ResultRow& row : rows) text += csv_line(row, measures);
  return text;
}

std::string results_json(const Study& study, std::span<const ResultRow> rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const ResultRow& row : rows) list.push_back(to_json(row));
  const nlohmann::json json = {
      {"format", "pellucid-results"},
      {"version", 1},
      {"study", {{"name", study.name}, {"title", study.title}, {"source", study.source}}},
      {"rows", list}};
  return json.dump(1) + "\n";
}

}  // namespace pellucid::compare
