// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "compare/measures/study_measures.h"

namespace pellucid::compare {
namespace {

double median_of(const std::pair<std::string, Spread>& step) { return step.second.median; }

void measure(const MeasuredScene&, CellMeasurement& cell) {
  const auto& steps = cell.row.steps;
  if (steps.size() < 2) return;
  const auto longest = std::ranges::max_element(steps, {}, median_of);
  cell.row.measures.push_back({"longest_step", "Longest step, counted from 1", "",
                               double(longest - steps.begin() + 1),
                               scene::Measure::Better::neither});
}

}  // namespace

const StudyMeasure& longest_step_measure() {
  static constexpr StudyMeasure row{"longest-step", "Which of a method's steps takes longest",
                                    measure};
  return row;
}

}  // namespace pellucid::compare
