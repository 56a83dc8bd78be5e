// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "compare/measures/study_measures.h"

namespace pellucid::compare {
namespace {

/// Of the depth range: context that is as near as this is very close to what it lies in front of.
constexpr double very_close = 0.01;
/// Pixels, along rows and columns: context that is as near as this lies beside what is important.
constexpr int beside = 5;

/// The share s of the context's colours c in pixels C = s c + (1 - s) b in front of colours b: of
/// all its pixels the one of least squares, so that pixels whose two colours are alike, which do
/// not tell, count little. Where b is opaque it is the context's opacity.
class ContextShare {
 public:
  void add(const ContextOfRay& context, const Vec3& color) {
    const Vec3 between = context.color - context.behind;
    along_ += glm::dot(color - context.behind, between);
    squares_ += glm::dot(between, between);
  }
  bool is_known() const { return squares_ > 0; }
  double value() const { return along_ / squares_; }

 private:
  double along_ = 0, squares_ = 0;
};

bool is_beside_important(const Raster<double>& importance, int x, int y) {
  for (int j = std::max(y - beside, 0); j <= std::min(y + beside, importance.height - 1); ++j)
    for (int i = std::max(x - beside, 0); i <= std::min(x + beside, importance.width - 1); ++i)
      if (importance.at(i, j) >= important) return true;
  return false;
}

void add_measure(std::string name, std::string title, const ContextShare& share,
                 CellMeasurement& cell) {
  if (share.is_known())
    cell.row.measures.push_back(
        {std::move(name), std::move(title), "", share.value(), scene::Measure::Better::lower});
}

void measure(const MeasuredScene& of, CellMeasurement& cell) {
  const RayFacts& rays = of.rays();
  ContextShare in_front, of_close, of_beside;
  for (int y = 0; y < cell.image.height; ++y)
    for (int x = 0; x < cell.image.width; ++x) {
      const ContextOfRay& context = rays.context.at(x, y);
      const Vec3 color(cell.image.at(x, y));
      if (context.layers == 0) continue;
      if (!std::isnan(context.gap)) in_front.add(context, color);
      if (context.gap <= very_close) of_close.add(context, color);
      if (std::isnan(context.gap) && is_beside_important(rays.importance, x, y))
        of_beside.add(context, color);
    }
  add_measure("context_share", "Share of context in front of important layers", in_front, cell);
  add_measure("context_share_close", "… of context very close to them", of_close, cell);
  add_measure("context_share_beside", "… of context beside them", of_beside, cell);
}

}  // namespace

const StudyMeasure& context_share_measure() {
  static constexpr StudyMeasure row{
      "context-share", "How much context in front of important layers, and beside them, shows",
      measure};
  return row;
}

}  // namespace pellucid::compare
