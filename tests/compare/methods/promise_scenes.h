// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the tests of promises draw, and how they read a row's promises.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <string_view>

#include "tests/support/pictures.h"
#include "tests/support/scenes.h"

namespace pellucid::compare {

/// Slanted, intersecting triangles under a perspective camera; some reach behind the eye.
inline scene::Scene triangle_cloud(int width, int height, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  scene::Scene scene = testing::empty_scene(width, height);
  scene.camera = {.eye = {0, 0, 3}, .target = {0, 0, 0}};
  for (int i = 0; i < count; ++i) {
    geometry::TriangleMesh mesh;
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.emplace_back(1.5 * unit(random), 1.5 * unit(random), 4 * unit(random));
      mesh.normals.push_back(glm::normalize(Vec3(unit(random), unit(random), 1.5)));
      mesh.colors.emplace_back(0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random),
                               0.5 + 0.5 * unit(random), 0.5 + 0.5 * unit(random));
    }
    mesh.triangles = {{0, 1, 2}};
    scene.objects.push_back({"triangle", std::move(mesh)});
  }
  return scene;
}

/// Objects in an order of no meaning.
inline scene::Scene shuffled(scene::Scene scene, unsigned seed) {
  std::shuffle(scene.objects.begin(), scene.objects.end(), std::mt19937(seed));
  return scene;
}

/// Importance that grows with the red of a vertex.
inline scene::Scene with_importance(scene::Scene scene) {
  for (scene::SceneObject& object : scene.objects)
    for (const Rgba& color : object.vertices().colors)
      object.vertices().importance.push_back(color.r * color.r);
  return scene;
}

/// Does the row promise the exact composite of meshes and points without importance? It is then
/// that of lines, too, whose crossings lie far apart.
inline bool is_exact(const scene::MethodRow& row) {
  return row.promises.exact || row.promises.exact_without_isosurfaces ||
         row.promises.exact_without_importance || row.promises.exact_without_lines;
}

/// Is `name` one of "a|b|c"?
inline bool is_among(std::string_view name, std::string_view names) {
  return ("|" + std::string(names) + "|").find("|" + std::string(name) + "|") != std::string::npos;
}

/// "a=b".
inline RawOptions setting(std::string_view text) {
  const std::size_t equals = text.find('=');
  return {{std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))}};
}

/// Equal but for three pixels; of a row that is random, equal in the mean.
inline void expect_same(const scene::MethodRow& row, const Image& a, const Image& b) {
  const double pixels = double(a.pixels.size());
  std::size_t changed = 0;
  glm::dvec4 mean(0);
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const Rgba difference = a.pixels[i] - b.pixels[i];
    changed += glm::length(difference) > row.promises.change_by_rounding;
    mean += glm::dvec4(difference) / pixels;
  }
  EXPECT_LE(changed, row.promises.random ? a.pixels.size() : 3u);
  // A channel's deviation is at most 1/2, a difference's √2 as much, and six of the mean's are:
  const double noise = row.promises.random ? 6 * 0.5 * std::sqrt(2 / pixels) : 3.0 / pixels;
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(mean[c], 0, noise);
}

}  // namespace pellucid::compare
