// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <string_view>

#include "compare/measures/ray_facts.h"
#include "compare/results/cell_measurement.h"

namespace pellucid::compare {

/// A MeasuredScene is what a picture is measured by: the scene from its view, the reference of the
/// picture's size, and what the scene's rays tell, which are asked once for all pictures.
struct MeasuredScene {
  const scene::Scene& scene;
  const Image& reference;
  std::function<const RayFacts&()> rays;
};

/// A StudyMeasure is what a study may ask for of each of its pictures beyond the metrics:
/// "measures" in its file.
struct StudyMeasure {
  std::string_view name;
  std::string_view title;
  /// Adds to the row's measures, pictures and curves.
  void (*measure)(const MeasuredScene& of, CellMeasurement& cell);
};

/// Returns the measure of how far the picture's colours are from the convex hull of the colours
/// that a pixel is made of.
const StudyMeasure& hull_measure();

/// Returns the measure of the mean error over the depth d of a pixel's nearest layer.
const StudyMeasure& depth_error_measure();

/// Returns the measures rmse_important, over pixels whose ray crosses a layer of an importance of
/// 0.5 or more, and rmse_context, over those that cross lesser ones alone; each where there are
/// any.
const StudyMeasure& importance_error_measure();

/// Returns the measures boundary_step, of a method with `bins`: the mean step of the signed error
/// (root mean square over RGB) between neighbouring pixels where what shows most passes from one
/// bin of depth to the next; and boundary_step_ratio, over the same in the middles of bins. The
/// bins are equal parts of d.
const StudyMeasure& bin_steps_measure();

/// Returns the measures context_share, of the colour of pixels where context lies in front of an
/// important layer: the share of the context, 0 where it is transparent, 1 where it hides what lies
/// behind; context_share_close, where the two are 0.01 of the depth range apart at most; and
/// context_share_beside, of pixels that show context alone, 5 pixels at most from one whose ray
/// crosses an important layer: its share before the background.
const StudyMeasure& context_share_measure();

/// Returns the measure longest_step: the place, counted from 1, of the step that took longest among
/// those of the method, of which there are two at least.
const StudyMeasure& longest_step_measure();

/// Returns the table of these measures.
std::span<const StudyMeasure> study_measures();

}  // namespace pellucid::compare
