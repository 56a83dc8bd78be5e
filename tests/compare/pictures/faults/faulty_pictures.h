// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Pictures of one scene, right and with a fault that pictures from elsewhere may have.

#include <cmath>

#include "compare/methods/methods.h"
#include "core/options/names.h"
#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {

using namespace pellucid::testing;

constexpr int width = 120, height = 90;

/// Not symmetric, a third of it uncovered, edges in all directions.
inline scene::Scene any_scene(std::uint32_t seed) {
  scene::Scene scene = empty_scene(width, height);
  scene.objects.push_back({"triangles", random_triangles(40, seed, 0.9)});
  scene.objects.push_back({"quarter", rectangle(-0.9, 0.1, 0.2, 0.8, 0.3, {0.9, 0.2, 0.1, 0.7})});
  return scene;
}

inline Image drawn(const scene::Scene& scene, std::string_view method) {
  return render(find_row("method", method, methods()), scene).image;
}

/// The colours as they were before the background, premultiplied.
inline Image without_background(Image image, const Vec3& background) {
  for (Rgba& p : image.pixels) p -= Rgba(background, 0) * (1 - p.a);
  return image;
}

inline Image over(Image image, const Vec3& background) {
  for (Rgba& p : image.pixels) p += Rgba(background, 0) * (1 - p.a);
  return image;
}

inline Image straight(Image image, const Vec3& background) {
  image = without_background(image, background);
  for (Rgba& p : image.pixels)
    if (p.a > 0) p = Rgba(p.r / p.a, p.g / p.a, p.b / p.a, p.a);
  return image;
}

inline Image upside_down(const Image& image) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) result.at(x, y) = image.at(x, image.height - 1 - y);
  return result;
}

inline Image mirrored(const Image& image) {
  Image result = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) result.at(x, y) = image.at(image.width - 1 - x, y);
  return result;
}

inline Image curved(Image image, double exponent) {
  for (Rgba& p : image.pixels)
    for (int c = 0; c < 3; ++c) p[c] = float(std::pow(double(p[c]), exponent));
  return image;
}

inline Image without_alpha(Image image) {
  for (Rgba& p : image.pixels) p.a = 1;
  return image;
}

inline scene::Scene with_opacities(scene::Scene scene, double least, double most) {
  for (scene::SceneObject& object : scene.objects)
    for (Rgba& color : object.vertices().colors)
      color.a = float(least + (most - least) * double(color.a));
  return scene;
}

/// The same scene, moved by so many pixels to the right and down.
inline Image moved(scene::Scene scene, double right, double down) {
  const double pixel = scene.camera.height / height;
  scene.camera.eye += Vec3(-right * pixel, down * pixel, 0);
  scene.camera.target += Vec3(-right * pixel, down * pixel, 0);
  return drawn(scene, "raytrace");
}

}  // namespace pellucid::compare
