// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/budget/split_error.h"

#include <algorithm>
#include <cmath>

namespace pellucid::compare {
namespace {

using Difference = Raster<Vec3>;

StageSet all_of(const StageOrder& order) { return (1u << order.size()) - 1; }

/// What has to be refined before a stage.
StageSet before(const StageOrder& order, std::size_t stage) {
  StageSet set = 0;
  for (std::optional<std::size_t> at = order[stage]; at; at = order[*at]) set |= 1u << *at;
  return set;
}

/// What can be refined only after a stage.
StageSet after(const StageOrder& order, std::size_t stage) {
  StageSet set = 0;
  for (std::size_t other = 0; other < order.size(); ++other)
    if (before(order, other) & (1u << stage)) set |= 1u << other;
  return set;
}

/// A Step is a stage that is refined upon others.
struct Step {
  StageSet from, to;
};

Step first_step(const StageOrder& order, std::size_t stage) {
  const StageSet set = before(order, stage);
  return {set, set | (1u << stage)};
}

Step last_step(const StageOrder& order, std::size_t stage) {
  const StageSet set = all_of(order) & ~after(order, stage);
  return {set & ~(1u << stage), set};
}

Vec3 rgb(const Rgba& color) { return Vec3(color.r, color.g, color.b); }

Difference difference(const Image& a, const Image& b) {
  Difference d(a.width, a.height);
  for (std::size_t i = 0; i < d.pixels.size(); ++i)
    d.pixels[i] = rgb(a.pixels[i]) - rgb(b.pixels[i]);
  return d;
}

double product(const Difference& a, const Difference& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += glm::dot(a.pixels[i], b.pixels[i]);
  return sum;
}

double rms(const Difference& d) {
  return std::sqrt(product(d, d) / (3.0 * double(d.pixels.size())));
}

Difference mean_of(const Difference& a, const Difference& b) {
  Difference mean = a;
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = 0.5 * (a.pixels[i] + b.pixels[i]);
  return mean;
}

Raster<double> amounts_of(const Difference& d) {
  Raster<double> amounts(d.width, d.height);
  std::ranges::transform(d.pixels, amounts.pixels.begin(), [](const Vec3& v) {
    return std::max({std::abs(v.r), std::abs(v.g), std::abs(v.b)});
  });
  return amounts;
}

/// What a picture takes beyond making the scene, if that costs another picture the same; nothing
/// where a time has no interval.
std::optional<Interval> time_interval(const DrawnPicture& picture, bool with_scene) {
  const std::optional<Interval>&drawing = picture.drawing.interval,
        &making = picture.making.interval;
  if (!with_scene || !drawing) return drawing;
  if (!making) return std::nullopt;
  return Interval{drawing->low + making->low, drawing->high + making->high};
}

/// How much longer `b` takes; NaN where that is not told from chance.
double seconds_between(const DrawnPicture& a, const DrawnPicture& b) {
  const bool with_scene = a.scene != b.scene;
  const auto of_a = time_interval(a, with_scene), of_b = time_interval(b, with_scene);
  if (!of_a || !of_b || overlap(*of_a, *of_b)) return std::nan("");
  const double drawing = b.drawing.median - a.drawing.median;
  return with_scene ? drawing + b.making.median - a.making.median : drawing;
}

class Splitting {
 public:
  Splitting(const StageOrder& order, const std::map<StageSet, DrawnPicture>& pictures)
      : order_(order),
        pictures_(pictures),
        error_(difference(image(0), image(all_of(order)))),
        square_(product(error_, error_)) {}

  SplitError split() const {
    SplitError result{{rms(error_), pictures_.at(0).seconds(), square_ > 0 ? 1.0 : 0.0, {}}, {}};
    for (std::size_t stage = 0; stage < order_.size(); ++stage) {
      result.budget.lines.push_back(line(stage, result.amounts));
      result.budget.interaction -= result.budget.lines.back().share;
    }
    return result;
  }

 private:
  const Image& image(StageSet set) const { return pictures_.at(set).image; }
  Difference change(const Step& step) const { return difference(image(step.from), image(step.to)); }
  double share(const Difference& d) const { return square_ > 0 ? product(d, error_) / square_ : 0; }
  double rmse(StageSet set) const { return rms(difference(image(set), image(all_of(order_)))); }

  BudgetLine line(std::size_t stage, std::vector<Raster<double>>& amounts) const {
    const Step first = first_step(order_, stage);
    const Difference at_first = change(first), at_last = change(last_step(order_, stage));
    const Difference mean = mean_of(at_first, at_last);
    amounts.push_back(amounts_of(mean));
    BudgetLine line;
    line.first = share(at_first);
    line.last = share(at_last);
    line.share = 0.5 * (line.first + line.last);
    line.rmse = rms(mean);
    line.gain = rmse(first.from) - rmse(first.to);
    line.seconds = seconds_between(pictures_.at(first.from), pictures_.at(first.to));
    return line;
  }

  const StageOrder& order_;
  const std::map<StageSet, DrawnPicture>& pictures_;
  Difference error_;
  double square_;
};

}  // namespace

std::set<StageSet> sets_to_draw(const StageOrder& order) {
  std::set<StageSet> sets{0, all_of(order)};
  for (std::size_t stage = 0; stage < order.size(); ++stage)
    for (const Step& step : {first_step(order, stage), last_step(order, stage)}) {
      sets.insert(step.from);
      sets.insert(step.to);
    }
  return sets;
}

std::set<StageSet> sets_to_time(const StageOrder& order) {
  std::set<StageSet> sets{0};  // where a first step begins, if not where another one ends
  for (std::size_t stage = 0; stage < order.size(); ++stage)
    sets.insert(first_step(order, stage).to);
  return sets;
}

SplitError split_error(const StageOrder& order, const std::map<StageSet, DrawnPicture>& pictures) {
  return Splitting(order, pictures).split();
}

}  // namespace pellucid::compare
