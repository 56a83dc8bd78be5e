// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/study/costs.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/results/columns.h"
#include "compare/study/study.h"

namespace pellucid::compare {
namespace {

/// The place of a step's name, which is added if it is new.
std::size_t place_of(const std::string& step, CostTable& table) {
  const auto found = std::ranges::find(table.steps, step);
  if (found != table.steps.end()) return std::size_t(found - table.steps.begin());
  table.steps.push_back(step);
  return table.steps.size() - 1;
}

void find_bottleneck(CostLine& line) {
  const auto known =
      std::ranges::count_if(line.steps, [](const auto& step) { return step.has_value(); });
  if (known < 2) return;  // std::nullopt is less than any time
  line.bottleneck = std::size_t(std::ranges::max_element(line.steps) - line.steps.begin());
}

CostLine measured_line(const ResultRow& row, CostTable& table) {
  CostLine line{row.scene, row.call(), {}, {}, {}, {}};
  if (const auto seconds = known_seconds(row)) line.milliseconds = 1e3 * *seconds;
  if (row.given.empty() || !row.bytes.empty()) line.bytes = double(row.total_bytes());
  for (const auto& [name, spread] : row.steps) {
    const std::size_t place = place_of(name, table);
    line.steps.resize(std::max(line.steps.size(), place + 1));
    line.steps[place] = line.steps[place].value_or(0) + 1e3 * spread.median;
  }
  return line;
}

void finish(CostTable& table) {
  for (CostLine& line : table.lines) {
    line.steps.resize(table.steps.size());
    find_bottleneck(line);
  }
}

/// A method's lines, whatever its parameters.
CostTable measured_table(const std::string& method, std::span<const ResultRow> rows) {
  CostTable table{method + ", here", {}, {}};
  for (const ResultRow& row : rows)
    if (row.method == method && row.error.empty()) table.lines.push_back(measured_line(row, table));
  finish(table);
  return table;
}

CostTable published_table(const PublishedCosts& costs) {
  CostTable table{"As published, on " + costs.machine, costs.steps, {}};
  for (const PublishedCost& cost : costs.rows) {
    CostLine line{cost.scene, cost.call, cost.milliseconds, cost.bytes, {}, {}};
    line.steps.assign(cost.steps.begin(), cost.steps.end());
    table.lines.push_back(std::move(line));
  }
  finish(table);
  return table;
}

std::optional<double> published_milliseconds(const PublishedCosts& costs, const std::string& scene,
                                             const std::string& call) {
  for (const PublishedCost& cost : costs.rows)
    if (cost.scene == scene && cost.call == call) return cost.milliseconds;
  return std::nullopt;
}

}  // namespace

std::vector<CostTable> cost_tables(const Study& study, std::span<const ResultRow> rows) {
  if (!study.published) return {};
  std::vector<std::string> methods;
  for (const ResultRow& row : rows)
    if (row.error.empty() && std::ranges::find(methods, row.method) == methods.end())
      methods.push_back(row.method);
  std::vector<CostTable> tables;
  for (const std::string& method : methods) tables.push_back(measured_table(method, rows));
  tables.push_back(published_table(*study.published));
  return tables;
}

std::vector<CostRatio> cost_ratios(const Study& study, std::span<const ResultRow> rows) {
  std::vector<CostRatio> ratios;
  if (!study.published) return ratios;
  for (const ResultRow& row : rows) {
    if (row.reference || !row.error.empty()) continue;
    const auto reference = std::ranges::find_if(rows, [&](const ResultRow& other) {
      return other.reference && other.error.empty() && other.scene == row.scene;
    });
    if (reference == rows.end()) continue;
    CostRatio ratio{row.scene, row.call(), {}, {}};
    const auto seconds = known_seconds(row), longer = known_seconds(*reference);
    if (seconds && longer && *seconds > 0) ratio.here = *longer / *seconds;
    const auto ours = published_milliseconds(*study.published, row.scene, row.call());
    const auto theirs = published_milliseconds(*study.published, row.scene, reference->call());
    if (ours && theirs) ratio.published = *theirs / *ours;
    ratios.push_back(ratio);
  }
  return ratios;
}

}  // namespace pellucid::compare
