// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/measure_columns.h"

#include <fmt/format.h>

#include <algorithm>

namespace pellucid::compare {
namespace {

auto find(std::span<const scene::Measure> measures, std::string_view name) {
  return std::find_if(measures.begin(), measures.end(),
                      [&](const scene::Measure& m) { return m.name == name; });
}

}  // namespace

std::vector<scene::Measure> measure_columns(std::span<const ResultRow> rows) {
  std::vector<scene::Measure> columns;
  for (const ResultRow& row : rows)
    for (const scene::Measure& measure : row.measures) {
      const std::span<const scene::Measure> known(columns);
      if (find(known, measure.name) == known.end()) columns.push_back(measure);
    }
  return columns;
}

std::optional<double> measure_of(const ResultRow& row, std::string_view name) {
  const std::span<const scene::Measure> measures(row.measures);
  const auto found = find(measures, name);
  return found == measures.end() ? std::nullopt : std::optional(found->value);
}

std::string heading(const scene::Measure& measure) {
  return measure.unit.empty() ? measure.title : fmt::format("{} [{}]", measure.title, measure.unit);
}

}  // namespace pellucid::compare
