// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/results/provenance.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "compare/results/time_warnings.h"

namespace pellucid::compare {
namespace {

std::string fact(const ResultRow& row, const std::string& name) {
  const auto found = row.machine.find(name);
  return found == row.machine.end() ? "unknown" : found->second;
}

/// Rows that failed hold no number.
template <class Name>
std::set<std::string> names(std::span<const ResultRow> rows, const Name& name) {
  std::set<std::string> all;
  for (const ResultRow& row : rows)
    if (row.error.empty()) all.insert(name(row));
  return all;
}

/// Enough of a build's hash to tell it from the others.
std::string build_of(const ResultRow& row) {
  return fmt::format("{} ({})", fact(row, "commit"), fact(row, "build").substr(0, 8));
}

std::string machine_of(const ResultRow& row) {
  return fmt::format("{}, {} cores, {} GiB, {}", fact(row, "cpu"), fact(row, "cores"),
                     fact(row, "memory_gib"), fact(row, "kernel"));
}

}  // namespace

std::vector<std::string> provenance_warnings(std::span<const ResultRow> rows) {
  std::vector<std::string> warnings;
  if (const auto builds = names(rows, build_of); builds.size() > 1)
    warnings.push_back(fmt::format("The rows come from {} builds of the program: {}.",
                                   builds.size(), fmt::join(builds, "; ")));
  if (const auto machines = names(rows, machine_of); machines.size() > 1)
    warnings.push_back(
        fmt::format("The rows come from {} machines, so that their times do not compare: {}.",
                    machines.size(), fmt::join(machines, "; ")));
  else
    std::ranges::move(time_warnings(rows), std::back_inserter(warnings));
  for (const ResultRow& row : rows)
    for (const std::string& fault : row.given_faults)
      warnings.push_back(fmt::format("{}/{}: the picture {}.", row.scene, row.call(), fault));
  return warnings;
}

}  // namespace pellucid::compare
