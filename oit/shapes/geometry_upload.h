// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A scene's shapes in buffers of the driver, written there directly: there is never a second copy.

#include "oit/gl/gl_objects.h"
#include "oit/shapes/view_space.h"

namespace pellucid::oit {

using IndexTriangle = std::array<std::uint32_t, 3>;

/// Triangles of all meshes, or of all ribbons. 28 bytes a vertex, 12 a triangle, and 12 more a
/// vertex where the scene is lit. A point of a line has two vertices.
struct IndexedVertices {
  explicit IndexedVertices(const Gl& gl) : array(gl) {}

  VertexArray array;
  Buffer vertices, directions, importance, opacity, indices;
};

IndexedVertices upload_meshes(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);
IndexedVertices upload_ribbons(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);
/// 32 bytes a point: see disc.vert.glsl.
BufferTexture upload_discs(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);

void upload_mesh_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& meshes);
void upload_ribbon_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& ribbons);
/// Opacities that a vertex has beside its colour's, `copies` times each; written again they replace
/// the old ones. For programs with the define OPTIMIZED_VERTICES.
void upload_opacities(const Gl& gl, std::span<const float> opacities, int copies,
                      IndexedVertices& vertices);
BufferTexture upload_disc_importance(const Gl& gl, const scene::Scene& scene);

}  // namespace pellucid::oit
