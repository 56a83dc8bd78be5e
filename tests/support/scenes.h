// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Scenes with known answers, for the tests of every room from scene/ on.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace pellucid::testing {

/// Looks along -z at the square [-1, 1]², which fills the picture.
inline scene::Scene orthographic_scene(int width, int height) {
  scene::Scene scene;
  scene.width = width;
  scene.height = height;
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.height = 2;
  return scene;
}

/// The rectangle [x0, x1] × [y0, y1] at z, of one colour.
inline geometry::TriangleMesh rectangle(double x0, double x1, double y0, double y1, double z,
                                        const Rgba& color) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
  mesh.colors.assign(4, color);
  mesh.normals.assign(4, Vec3(0, 0, 1));
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// Larger than the picture of orthographic_scene() of any shape up to 50 : 1, so that it covers
/// every pixel.
inline geometry::TriangleMesh full_layer(double z, const Rgba& color) {
  return rectangle(-50, 50, -50, 50, z, color);
}

inline scene::SceneObject sheet(double z, const Rgba& color) {
  return {"sheet", full_layer(z, color)};
}

/// An orthographic_scene() without objects. No channel of its background is that of another, or at
/// an end of its range.
inline scene::Scene empty_scene(int width, int height) {
  scene::Scene scene = orthographic_scene(width, height);
  scene.name = "test";
  scene.background = {0.1, 0.5, 0.9};
  return scene;
}

/// n layers between z = 1 (front) and z = -1, one object each, given back to front or shuffled by
/// `order`; `color_of(i)` is the colour of the i-th from the front.
template <class ColorOf>
scene::Scene stack(int n, int width, int height, const ColorOf& color_of,
                   std::uint32_t shuffle_seed = 0) {
  scene::Scene scene = orthographic_scene(width, height);
  for (int i = 0; i < n; ++i) {
    const double z = n == 1 ? 0.0 : 1 - 2.0 * i / (n - 1);
    scene.objects.push_back(sheet(z, color_of(i)));
  }
  std::mt19937 random(shuffle_seed);
  if (shuffle_seed != 0) std::shuffle(scene.objects.begin(), scene.objects.end(), random);
  return scene;
}

/// These layers, front to back, over the background of empty_scene().
inline scene::Scene stack(int width, int height, const std::vector<Rgba>& front_to_back) {
  scene::Scene scene = stack(int(front_to_back.size()), width, height,
                             [&](int i) { return front_to_back[std::size_t(i)]; });
  scene.background = empty_scene(width, height).background;
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

/// Unit sphere from a subdivided octahedron; closed, vertices shared.
inline geometry::TriangleMesh sphere(int subdivisions, const Rgba& color) {
  geometry::TriangleMesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> midpoints;
    const auto midpoint = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, added] = midpoints.try_emplace(std::minmax(a, b), mesh.positions.size());
      if (added) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  mesh.normals = mesh.positions;
  mesh.colors.assign(mesh.positions.size(), color);
  return mesh;
}

/// Triangles of random corners in [-1, 1]³ with random colours and opacities.
inline geometry::TriangleMesh random_triangles(int count, std::uint32_t seed, double size = 2) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto any = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  geometry::TriangleMesh mesh;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    const Vec3 center = any() * 2.0 - 1.0;
    for (int corner = 0; corner < 3; ++corner) {
      mesh.positions.push_back(center * (1 - size / 2) + (any() - 0.5) * size);
      mesh.colors.push_back(Rgba(any(), 0.1 + 0.8 * uniform(random)));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

}  // namespace pellucid::testing
