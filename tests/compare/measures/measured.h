// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What measures of a study are asked about.

#include "compare/measures/study_measures.h"

namespace pellucid::compare::testing {

/// A picture of one colour.
inline CellMeasurement picture_of(const scene::Scene& scene, const Rgba& color) {
  CellMeasurement cell;
  cell.image = Image(scene.width, scene.height, color);
  return cell;
}

/// Rays are asked whenever a measure wants them.
inline MeasuredScene seen(const scene::Scene& scene, const Image& reference) {
  static RayFacts facts;
  return {scene, reference, [&scene]() -> const RayFacts& { return facts = ray_facts(scene); }};
}

}  // namespace pellucid::compare::testing
