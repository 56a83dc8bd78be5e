// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace pellucid::oit {

/// A ShapeKind says how OpenGL draws a shape, in the order of SceneObject::shape.
enum class ShapeKind { mesh, ribbon, disc };

/// The table holds every kind, in order.
inline constexpr std::array shape_kinds = {ShapeKind::mesh, ShapeKind::ribbon, ShapeKind::disc};

/// Returns the kind of an object that is no isosurface.
inline ShapeKind kind_of(const scene::SceneObject& object) {
  return ShapeKind(object.shape.index());
}

/// Returns the number of triangles of a mesh, of triangles of ribbons (two a segment), or of
/// points.
std::uint64_t primitive_count(const scene::SceneObject& object);

/// A Batch is a run of primitives of one kind that follow each other in the scene.
struct Batch {
  ShapeKind kind = ShapeKind::mesh;
  bool opaque = false;
  std::uint32_t first_primitive = 0;  // in the order of the scene, see scene.h
  std::uint32_t first = 0;            // among those of its kind
  std::uint32_t count = 0;
};

/// Returns the batches of a whole scene. Throws InputError for shapes that OpenGL does not draw
/// here (isosurfaces, tubes, spheres) and for 2^31 / 3 primitives or more.
std::vector<Batch> make_batches(const scene::Scene& scene);

}  // namespace pellucid::oit
