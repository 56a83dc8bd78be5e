// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/splats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pellucid::geometry {
namespace {

/// Y₀⁰, the spherical harmonic of degree 0.
const double harmonic_0 = 0.5 / std::sqrt(std::numbers::pi);

}  // namespace

bool are_splats(const VertexAttributes& attributes) {
  static constexpr const char* names[] = {"f_dc_0",  "f_dc_1",  "f_dc_2", "opacity",
                                          "scale_0", "scale_1", "scale_2"};
  return std::ranges::all_of(names, [&](const char* name) { return attributes.contains(name); });
}

void take_splats(VertexAttributes& attributes) {
  static constexpr const char* channels[] = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c) {
    std::vector<double>& channel = attributes[channels[c]];
    channel = std::move(attributes.extract(fmt::format("f_dc_{}", c)).mapped());
    for (double& value : channel) value = std::clamp(0.5 + harmonic_0 * value, 0.0, 1.0);
  }
  std::vector<double>& alpha = attributes["alpha"];
  alpha = std::move(attributes.extract("opacity").mapped());
  for (double& value : alpha) value = 1 / (1 + std::exp(-value));
  std::vector<double> radius(alpha.size(), 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto scale = attributes.extract(fmt::format("scale_{}", axis));
    for (std::size_t i = 0; i < radius.size(); ++i) radius[i] += scale.mapped()[i] / 3;
  }
  for (double& value : radius) value = std::exp(value);
  attributes["radius"] = std::move(radius);
  std::erase_if(attributes, [](const auto& entry) { return entry.first.starts_with("f_rest_"); });
}

}  // namespace pellucid::geometry
