// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// A StudyMeasure is what a study may ask for of each of its pictures beyond the metrics:
/// "measures" in its file.
struct StudyMeasure {
  std::string_view name;
  std::string_view title;
  /// Adds to the row's measures, pictures and curves. `reference` has the picture's size.
  void (*measure)(const scene::Scene& scene, const Image& reference, CellMeasurement& cell);
};

/// Returns the measure of how far the picture's colours are from the convex hull of the colours
/// that a pixel is made of.
const StudyMeasure& hull_measure();

/// Returns the measure of the mean error over the depth d of a pixel's nearest layer.
const StudyMeasure& depth_error_measure();

/// Returns the table of these measures.
std::span<const StudyMeasure> study_measures();

}  // namespace pellucid::compare
