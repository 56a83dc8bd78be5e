// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "compare/results/result_row.h"

namespace pellucid::compare {

struct Study;

/// A PublishedCost is what the study's source printed of one method on one scene, on the source's
/// own machine.
struct PublishedCost {
  std::string scene, call;
  double milliseconds = 0;
  std::optional<double> bytes;
  std::vector<double> steps;  // milliseconds, in the source's order
};

/// PublishedCosts are a table of times that a study's source published.
struct PublishedCosts {
  std::string machine;             // what the source measured on
  std::vector<std::string> steps;  // the source's names
  std::vector<PublishedCost> rows;
};

/// A CostLine is one line of a table of costs.
struct CostLine {
  std::string scene, call;
  std::optional<double> milliseconds;  // nothing where nobody told them
  std::optional<double> bytes;
  std::vector<std::optional<double>> steps;  // milliseconds, as CostTable::steps
  std::optional<std::size_t> bottleneck;     // the longest of several steps
};

/// A CostTable is what one method costs on every scene, step by step: here, or where the source
/// measured it.
struct CostTable {
  std::string title;
  std::vector<std::string> steps;
  std::vector<CostLine> lines;
};

/// A CostRatio tells how many times as long as `call` the reference takes on a scene, and the
/// source's own ratio; nothing where a time is not known.
struct CostRatio {
  std::string scene, call;
  std::optional<double> here, published;
};

/// A table for each method of a study that gives published costs, then the source's; empty for any
/// other study.
std::vector<CostTable> cost_tables(const Study& study, std::span<const ResultRow> rows);

/// Returns the ratios of every method on every scene where the reference was measured, too.
std::vector<CostRatio> cost_ratios(const Study& study, std::span<const ResultRow> rows);

}  // namespace pellucid::compare
