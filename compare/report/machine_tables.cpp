// SPDX-License-Identifier: GPL-3.0-or-later
// The tables for programs: CSV and JSON.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>

#include "compare/report/source_json.h"
#include "compare/report/tables.h"
#include "compare/results/columns.h"
#include "compare/results/measure_columns.h"
#include "compare/results/provenance.h"
#include "core/files/json_text.h"

namespace pellucid::compare {
namespace {

/// Counts are whole: no exponent, whatever their size.
std::string csv_number(const Column& column, const ResultRow& row) {
  const std::optional<double> value = column.value(row);
  const bool whole = column.style == NumberStyle::count || column.style == NumberStyle::megabytes;
  return value && whole ? fmt::format("{:.0f}", *value) : csv_digits(value);
}

struct TextColumn {
  std::string_view name;
  std::string (*text)(const ResultRow&);
};

constexpr TextColumn identity_columns[] = {
    {"scene", [](const ResultRow& r) { return r.scene; }},
    {"method", [](const ResultRow& r) { return r.method; }},
    {"parameters", [](const ResultRow& r) { return r.parameters; }}};

std::string csv_header(std::span<const scene::Measure> measures) {
  std::string line;
  for (const TextColumn& column : identity_columns) line += fmt::format("{},", column.name);
  for (const Column& column : columns()) line += column.name + ',';
  for (const scene::Measure& measure : measures) line += csv_field(measure.name) + ',';
  return line + "error\n";
}

std::string csv_line(const ResultRow& row, std::span<const scene::Measure> measures) {
  std::string line;
  for (const TextColumn& column : identity_columns) line += csv_field(column.text(row)) + ',';
  for (const Column& column : columns())
    line += (row.error.empty() ? csv_number(column, row) : "") + ',';
  for (const scene::Measure& measure : measures)
    line += csv_digits(measure_of(row, measure.name)) + ',';
  return line + csv_field(row.error) + '\n';
}

}  // namespace

std::string csv_field(std::string text) {
  if (!text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos)
    text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csv_digits(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string csv_table(std::span<const ResultRow> rows) {
  const std::vector<scene::Measure> measures = measure_columns(rows);
  std::string text = csv_header(measures);
  for (const ResultRow& row : rows) text += csv_line(row, measures);
  return text;
}

std::string results_json(const Study& study, std::span<const ResultRow> rows) {
  nlohmann::json list = nlohmann::json::array();
  for (const ResultRow& row : rows) list.push_back(to_json(row));
  const nlohmann::json json = {{"format", "pellucid-results"},
                               {"version", 1},
                               {"study", study_json(study)},
                               {"warnings", provenance_warnings(rows)},
                               {"rows", list}};
  return json_text(json, 1) + "\n";
}

}  // namespace pellucid::compare
