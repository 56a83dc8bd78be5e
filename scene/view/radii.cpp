// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/radii.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace pellucid::scene {

double RadiusSpan::largest() const { return each_.empty() ? one_ : std::ranges::max(each_); }

Radii::Radii(std::vector<double> each) : largest_(each.empty() ? 0 : std::ranges::max(each)) {
  const bool differ = std::ranges::adjacent_find(each, std::not_equal_to{}) != each.end();
  if (differ) each_ = std::move(each);
}

Radii& Radii::operator*=(double factor) {
  largest_ *= factor;
  for (double& radius : each_) radius *= factor;
  return *this;
}

}  // namespace pellucid::scene
