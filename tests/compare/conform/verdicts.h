// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "compare/conform/conform.h"

namespace pellucid::compare::testing {

/// A right renderer but for what becomes of each pixel's layers.
class UnitVerdict : public ::testing::Test {
 protected:
  static const ConformanceCase& named(std::string_view name) {
    static const std::vector<ConformanceCase> cases = conformance_cases();
    return *std::ranges::find(cases, name, &ConformanceCase::name);
  }

  static Verdict verdict(std::string_view name, const std::function<Layers(Layers)>& change,
                         std::optional<Vec3> background = std::nullopt) {
    const ConformanceCase& c = named(name);
    Image image(c.scene.width, c.scene.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      image.pixels[i] =
          Rgba(composite_of(change(c.of_pixel(i)), background.value_or(c.scene.background)));
    return judge(c, image, false);
  }

  static Layers as_they_are(Layers layers) { return layers; }
  static Layers backwards(Layers layers) {
    std::ranges::reverse(layers);
    return layers;
  }
  static float to_half(float x) { return glm::unpackHalf1x16(glm::packHalf1x16(x)); }
};

}  // namespace pellucid::compare::testing
