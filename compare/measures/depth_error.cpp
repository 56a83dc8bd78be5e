// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "compare/measures/study_measures.h"
#include "compare/pictures/error_map.h"

namespace pellucid::compare {
namespace {

/// Twenty to each of eleven bins of depth, so that the bins' boundaries are among their ends.
constexpr int classes = 220;

void measure(const MeasuredScene& of, CellMeasurement& cell) {
  const Raster<double>& depths = of.rays().nearest_depth;
  std::vector<double> sums(classes), counts(classes);
  for (std::size_t i = 0; i < depths.pixels.size(); ++i) {
    if (std::isnan(depths.pixels[i])) continue;
    const std::size_t k =
        std::min(std::size_t(depths.pixels[i] * classes), std::size_t(classes - 1));
    sums[k] += pixel_error(of.reference.pixels[i], cell.image.pixels[i]);
    ++counts[k];
  }
  RowCurve curve{"depth error",
                 "",
                 "Error over the depth of the nearest layer",
                 "d of the nearest layer",
                 "mean error",
                 {},
                 {}};
  for (int k = 0; k < classes; ++k) {
    if (counts[std::size_t(k)] == 0) continue;
    curve.x.push_back((k + 0.5) / classes);
    curve.y.push_back(sums[std::size_t(k)] / counts[std::size_t(k)]);
  }
  cell.row.curves.push_back(std::move(curve));
}

}  // namespace

const StudyMeasure& depth_error_measure() {
  static constexpr StudyMeasure row{"depth-error", "Error over the depth of the nearest layer",
                                    measure};
  return row;
}

}  // namespace pellucid::compare
