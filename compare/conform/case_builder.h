// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "compare/conform/conformance_case.h"

namespace pellucid::compare {

/// The pictures' sides, in pixels. A pixel of the parallel camera is one world unit, so that pixel
/// centres are at halves, and the picture is [-8, 8]².
inline constexpr int case_side = 16;

/// A Plane is z = z0 + slope · (x, y), of one colour.
struct Plane {
  double z0 = 0;
  Vec2 slope{0, 0};
  Rgba color;

  double at(const Vec2& x) const { return z0 + glm::dot(slope, x); }
};

/// A number in [0, 1) of the index: the same on every machine (SplitMix64).
inline double random_of(std::uint64_t index) {
  std::uint64_t x = (index + 1) * 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return double((x ^ (x >> 31)) >> 11) * 0x1p-53;
}

/// A colour of the index, of this opacity.
inline Rgba color_of(std::uint64_t index, double alpha) {
  return Rgba(random_of(3 * index), random_of(3 * index + 1), random_of(3 * index + 2), alpha);
}

/// Looks along -z from `eye` at a picture of [-8, 8]², in parallel.
inline scene::Scene parallel_scene(const Vec3& eye = {0, 0, 64}) {
  scene::Scene scene;
  scene.width = scene.height = case_side;
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.height = case_side;
  scene.camera.eye = eye;
  scene.camera.target = eye - Vec3(0, 0, 64);
  scene.background = {0.1, 0.5, 0.9};
  return scene;
}

/// Returns the centre of a pixel of parallel_scene(), relative to the eye.
inline Vec2 center_of(int x, int y) {
  return {x + 0.5 - case_side / 2.0, case_side / 2.0 - y - 0.5};
}

/// Adds one triangle that covers the picture and lies in the plane: no edge is near a pixel.
inline void add_plane(const Plane& plane, geometry::TriangleMesh& mesh) {
  const auto first = std::uint32_t(mesh.positions.size());
  for (const Vec2& x : {Vec2(-64, -32), Vec2(64, -32), Vec2(0, 96)}) {
    mesh.positions.emplace_back(x, plane.at(x));
    mesh.colors.push_back(plane.color);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
}

/// Returns a transparent object of the mesh.
inline scene::SceneObject object_of(geometry::TriangleMesh mesh, const char* name = "sheets") {
  return {name, std::move(mesh)};
}

/// Fills the pixels by layers_at(x, y), with columns and rows from the top left.
template <class LayersAt>
void set_layers(ConformanceCase& c, const LayersAt& layers_at) {
  c.which = Raster<int>(c.scene.width, c.scene.height);
  for (int y = 0; y < c.scene.height; ++y)
    for (int x = 0; x < c.scene.width; ++x) {
      Layers layers = layers_at(x, y);
      const auto known = std::find(c.layers.begin(), c.layers.end(), layers);
      c.which.at(x, y) = int(known - c.layers.begin());
      if (known == c.layers.end()) c.layers.push_back(std::move(layers));
    }
}

/// Cases of sheets that cover the picture; of edges, planes and the camera; of lines and points.
///@{
void add_sheet_cases(std::vector<ConformanceCase>& cases);
void add_surface_cases(std::vector<ConformanceCase>& cases);
void add_shape_cases(std::vector<ConformanceCase>& cases);
///@}

}  // namespace pellucid::compare
