// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace pellucid::oit {

/// How OpenGL draws a shape, in the order of SceneObject::shape.
enum class ShapeKind { mesh, ribbon, disc };

inline constexpr std::array shape_kinds = {ShapeKind::mesh, ShapeKind::ribbon, ShapeKind::disc};

inline ShapeKind kind_of(const scene::SceneObject& object) {
  return ShapeKind(object.shape.index());
}

/// Triangles of a mesh, triangles of ribbons, or points.
std::uint64_t primitive_count(const scene::SceneObject& object);

/// Primitives of one kind that follow each other in the scene.
struct Batch {
  ShapeKind kind = ShapeKind::mesh;
  bool opaque = false;
  std::uint32_t first_primitive = 0;  // in the order of the scene, see scene.h
  std::uint32_t first = 0;            // among those of its kind
  std::uint32_t count = 0;
};

/// All of a scene. Throws InputError for shapes that no method draws (tubes, spheres) and for
/// 2^31 / 3 primitives or more.
std::vector<Batch> make_batches(const scene::Scene& scene);

}  // namespace pellucid::oit
