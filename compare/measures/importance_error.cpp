// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "compare/measures/study_measures.h"

namespace pellucid::compare {
namespace {

/// A root mean square over RGB, as the metric has it.
class MeanSquare {
 public:
  void add(const Rgba& a, const Rgba& b) {
    const Vec3 difference = Vec3(a) - Vec3(b);
    sum_ += glm::dot(difference, difference);
    ++pixels_;
  }
  double pixels() const { return double(pixels_); }
  double root() const { return std::sqrt(sum_ / (3 * pixels())); }

 private:
  double sum_ = 0;
  std::size_t pixels_ = 0;
};

/// Where nothing says what is important, nothing is context either.
void measure(const MeasuredScene& of, CellMeasurement& cell) {
  if (!has_importance(of.scene)) return;
  const Raster<double>& importance = of.rays().importance;
  MeanSquare of_important, of_context;
  for (std::size_t i = 0; i < importance.pixels.size(); ++i)
    if (!std::isnan(importance.pixels[i]))
      (importance.pixels[i] >= important ? of_important : of_context)
          .add(of.reference.pixels[i], cell.image.pixels[i]);
  using scene::Measure;
  if (of_important.pixels() > 0)
    cell.row.measures.push_back({"rmse_important", "RMSE where an important layer is crossed", "",
                                 of_important.root(), Measure::Better::lower});
  if (of_context.pixels() > 0)
    cell.row.measures.push_back({"rmse_context", "RMSE where context alone is crossed", "",
                                 of_context.root(), Measure::Better::lower});
}

}  // namespace

const StudyMeasure& importance_error_measure() {
  static constexpr StudyMeasure row{
      "importance-error", "Error of important pixels apart from that of context", measure};
  return row;
}

}  // namespace pellucid::compare
