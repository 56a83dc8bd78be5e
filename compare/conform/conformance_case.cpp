// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/conform/conformance_case.h"

#include "compare/conform/case_builder.h"

namespace pellucid::compare {

std::vector<ConformanceCase> conformance_cases() {
  std::vector<ConformanceCase> cases;
  add_sheet_cases(cases);
  add_surface_cases(cases);
  add_shape_cases(cases);
  for (ConformanceCase& c : cases) c.scene.name = c.name;
  return cases;
}

glm::dvec4 composite_of(const Layers& layers, const Vec3& background) {
  Vec3 color(0);
  double transmittance = 1;
  for (const Rgba& layer : layers) {
    color += transmittance * double(layer.a) * Vec3(layer);
    transmittance *= 1 - double(layer.a);
  }
  return {color + transmittance * background, 1 - transmittance};
}

Layers as_drawn(const ConformanceCase& c, Layers layers) {
  for (const scene::SceneObject& object : c.scene.objects) {
    if (!object.opaque) continue;
    const Rgba& color = object.vertices().colors.front();
    std::ranges::replace(layers, Rgba(glm::vec3(color), 1), color);
  }
  return layers;
}

Image expected_picture(const ConformanceCase& c) {
  std::vector<Rgba> pixels;
  for (const Layers& layers : c.layers)
    pixels.emplace_back(composite_of(layers, c.scene.background));
  Image image(c.scene.width, c.scene.height);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = pixels[std::size_t(c.which.pixels[i])];
  return image;
}

}  // namespace pellucid::compare
