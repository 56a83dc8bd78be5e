// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/stand_in.h"

#include <algorithm>

#include "core/parallel.h"
#include "scene/appearance/colormap.h"

namespace pellucid::scene {
namespace {

// Quantiles of so many values tell as much as those of all.
constexpr std::size_t most_sampled = 1 << 20;

std::vector<double> sample(const std::vector<double>& values) {
  const std::size_t stride = std::max<std::size_t>(1, values.size() / most_sampled);
  std::vector<double> some;
  for (std::size_t i = 0; i < values.size(); i += stride) some.push_back(values[i]);
  return some;
}

double quantile(std::vector<double>& values, double share) {
  const auto nth = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

void set_importance(std::string_view name, std::vector<double> values,
                    const ImportantShares& shares, geometry::Vertices& vertices) {
  std::vector<double> some = sample(values);
  const double low = some.empty() ? 0 : quantile(some, shares.none);
  const double high = some.empty() ? 1 : quantile(some, shares.full);
  const ColormapRow& map = find_colormap("coolwarm");
  vertices.importance.resize(values.size());
  vertices.colors.resize(values.size());
  parallel_for(std::size_t(0), values.size(), [&](std::size_t i) {
    values[i] =
        high > low ? std::clamp((values[i] - low) / (high - low), 0.0, 1.0) : values[i] > low;
    vertices.importance[i] = float(values[i]);
    vertices.colors[i] = Rgba(map(values[i]), 1);
  });
  vertices.scalars.clear();
  vertices.scalars.emplace(name, std::move(values));
}

}  // namespace pellucid::scene
