// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "compare/measures/study_measures.h"
#include "core/options/parameters.h"

namespace pellucid::compare {
namespace {

/// A mean over pairs of neighbouring pixels.
class MeanStep {
 public:
  void add(double step) {
    sum_ += step;
    ++pairs_;
  }
  bool is_known() const { return pairs_ > 0; }
  double value() const { return sum_ / double(pairs_); }

 private:
  double sum_ = 0;
  std::size_t pairs_ = 0;
};

/// The steps of a picture's signed error where what shows most passes from bin to bin, and, as a
/// control, where it passes the middle of one: surfaces are as steep there.
class BinSteps {
 public:
  BinSteps(const MeasuredScene& of, const Image& image, double bins)
      : depths_(of.rays().shown_depth), reference_(of.reference), image_(image), bins_(bins) {
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        if (x + 1 < image.width) add({x, y}, {x + 1, y});
        if (y + 1 < image.height) add({x, y}, {x, y + 1});
      }
  }
  const MeanStep& boundaries() const { return boundaries_; }
  const MeanStep& middles() const { return middles_; }

 private:
  struct Place {
    int x, y;
  };

  Vec3 error(Place at) const {
    return Vec3(image_.at(at.x, at.y)) - Vec3(reference_.at(at.x, at.y));
  }

  /// Less than half a bin apart, so that a pair passes one of the two at most, and is of one
  /// surface mostly.
  void add(Place p, Place q) {
    const double a = depths_.at(p.x, p.y) * bins_, b = depths_.at(q.x, q.y) * bins_;
    if (!(std::abs(a - b) < 0.5)) return;  // nor where one of them crosses nothing
    const double step = glm::length(error(p) - error(q)) / std::sqrt(3.0);
    if (std::floor(a) != std::floor(b)) boundaries_.add(step);
    if (std::floor(a + 0.5) != std::floor(b + 0.5)) middles_.add(step);
  }

  const Raster<double>& depths_;
  const Image &reference_, &image_;
  double bins_;
  MeanStep boundaries_, middles_;
};

void measure(const MeasuredScene& of, CellMeasurement& cell) {
  using scene::Measure;
  const auto found = cell.row.parameter_values.find("bins");
  double bins = 0;
  if (found == cell.row.parameter_values.end() || !parse_number(found->second, bins)) return;
  const BinSteps steps(of, cell.image, bins);
  if (!steps.boundaries().is_known() || !steps.middles().is_known()) return;
  const double boundary = steps.boundaries().value(), middle = steps.middles().value();
  cell.row.measures.push_back({"boundary_step", "Step of the error at boundaries of bins", "",
                               boundary, Measure::Better::lower});
  if (middle > 0)
    cell.row.measures.push_back({"boundary_step_ratio", "… over that in the middles of bins", "",
                                 boundary / middle, Measure::Better::lower});
}

}  // namespace

const StudyMeasure& bin_steps_measure() {
  static constexpr StudyMeasure row{"bin-steps", "Steps of the error at the boundaries of bins",
                                    measure};
  return row;
}

}  // namespace pellucid::compare
