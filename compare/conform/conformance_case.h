// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes of which every pixel's layers are known in closed form: what any renderer of transparency
// has to draw. Nothing here asks the exact renderer.

#include <string>
#include <string_view>
#include <vector>

#include "core/raster.h"
#include "scene/scene.h"

namespace pellucid::compare {

/// Layers are the fragments of a pixel, the nearest first.
using Layers = std::vector<Rgba>;

/// A ConformanceCase is a small scene and what each of its pixels shows. All coordinates are floats
/// as they stand, no pixel centre lies on the rim of what is drawn, and none within a 50th of a
/// pixel of it but where a case is about that.
struct ConformanceCase {
  std::string name;    // of its files: "layers-100"
  std::string family;  // what it tries: "layers"
  double n = 0;        // what grows along the family, in the order of the cases
  std::string what;    // one line, for people
  scene::Scene scene;
  std::vector<Layers> layers;  // different ones
  Raster<int> which;           // of them each pixel has

  const Layers& of_pixel(std::size_t i) const { return layers[std::size_t(which.pixels[i])]; }
};

/// Returns the suite, family by family, in each the easiest first.
std::vector<ConformanceCase> conformance_cases();

/// Returns the composite of the layers over the background, in double (Eq. 12 of Baeza Rojo et al.
/// 2019): colour and 1 - transmittance.
glm::dvec4 composite_of(const Layers& layers, const Vec3& background);

/// Returns the layers as their vertices have them, of an object that is said to be opaque, too.
Layers as_drawn(const ConformanceCase& conformance_case, Layers layers);

/// Returns the right picture.
Image expected_picture(const ConformanceCase& conformance_case);

}  // namespace pellucid::compare
