// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes made in code, with exactly known pictures.

#include <algorithm>
#include <random>
#include <vector>

#include "core/options/names.h"
#include "oit/registry.h"
#include "scene/scene.h"

namespace pellucid::oit::test {

/// An orthographic camera that looks along -z at [-1, 1]^2, from z = 5.
inline scene::Camera square_camera() {
  return {.projection = scene::Projection::orthographic,
          .eye = {0, 0, 5},
          .target = {0, 0, 0},
          .up = {0, 1, 0},
          .fov = 45,
          .height = 2};
}

inline scene::Scene empty_scene(int width, int height) {
  scene::Scene scene;
  scene.name = "test";
  scene.width = width;
  scene.height = height;
  scene.camera = square_camera();
  scene.background = {0.1, 0.5, 0.9};
  return scene;
}

/// A square over the whole picture, and beyond, at z.
inline scene::SceneObject sheet(double z, const Rgba& color) {
  scene::SceneObject object;
  object.name = "sheet";
  for (const Vec2 corner : {Vec2(-50, -50), Vec2(50, -50), Vec2(50, 50), Vec2(-50, 50)}) {
    object.mesh().positions.emplace_back(corner.x, corner.y, z);
    object.mesh().normals.emplace_back(0, 0, 1);
    object.mesh().colors.push_back(color);
  }
  object.mesh().triangles = {{0, 1, 2}, {0, 2, 3}};
  return object;
}

/// Layers from front to back at equal distances between z = 1 and z = -1.
inline scene::Scene stack(int width, int height, const std::vector<Rgba>& front_to_back) {
  scene::Scene scene = empty_scene(width, height);
  const double n = double(front_to_back.size());
  for (std::size_t i = 0; i < front_to_back.size(); ++i)
    scene.objects.push_back(sheet(n > 1 ? 1 - 2 * double(i) / (n - 1) : 0.0, front_to_back[i]));
  return scene;
}

/// Colours and opacities from a seed, opacities in [0, largest).
inline std::vector<Rgba> random_layers(int n, float largest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Rgba> layers;
  for (int i = 0; i < n; ++i) {
    const float r = unit(random), g = unit(random), b = unit(random);
    layers.emplace_back(r, g, b, largest * unit(random));
  }
  return layers;
}

/// The exact composite (Eq. 12 of Baeza Rojo et al. 2019) in double.
inline glm::dvec4 composite(const std::vector<Rgba>& front_to_back, const Vec3& background) {
  Vec3 color(0);
  double transmittance = 1;
  for (const Rgba& layer : front_to_back) {
    color += transmittance * double(layer.a) * Vec3(layer);
    transmittance *= 1 - double(layer.a);
  }
  return glm::dvec4(color + transmittance * background, 1 - transmittance);
}

inline const scene::MethodRow& method(std::string_view name) {
  return find_row("method", name, oit_methods());
}

inline scene::Rendering render(const scene::MethodRow& row, const scene::Scene& scene,
                               const RawOptions& options = {}, bool layers = false) {
  const Parameters parameters(row.name, row.parameters, options);
  return row.make(scene, parameters, {})->render({.layers = layers, .progress = {}});
}

/// Largest difference of any component of any pixel.
inline double max_difference(const Image& a, const Image& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 4; ++c)
      largest = std::max(largest, double(std::abs(a.pixels[i][c] - b.pixels[i][c])));
  return largest;
}

inline double max_difference(const Image& a, const glm::dvec4& b) {
  double largest = 0;
  for (const Rgba& pixel : a.pixels)
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(double(pixel[c]) - b[c]));
  return largest;
}

}  // namespace pellucid::oit::test
