// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A scene's shapes in buffers of the driver, written there directly: there is never a second copy.

#include "oit/gl/gl_objects.h"
#include "oit/shapes/clipped_triangles.h"
#include "oit/shapes/view_space.h"

namespace pellucid::oit {

/// IndexedVertices are the triangles of all meshes, or of all ribbons. They take 28 bytes a vertex,
/// 12 a triangle, and 12 more a vertex (16 of a ribbon) where the scene is lit. A point of a line
/// has two vertices. Of what was clipped the parts' vertices and triangles come last, and the
/// triangles themselves have no area.
struct IndexedVertices {
  explicit IndexedVertices(const Gl& gl) : array(gl) {}

  VertexArray array;
  Buffer vertices, directions, importance, opacity, indices;
  ClippedTriangles clipped;
};

/// Uploads positions, colours and triangles of all meshes, or of all ribbons, and where the scene
/// is lit their normals or directions; positions in the frame of `view`.
///@{
IndexedVertices upload_meshes(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);
IndexedVertices upload_ribbons(const Gl& gl, const scene::Scene& scene, const ViewSpace& view);
///@}

/// Uploads the importance of the scene's vertices, in [0, 1]: 4 bytes a vertex; 0 where an object
/// has none.
///@{
void upload_mesh_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& meshes);
void upload_ribbon_importance(const Gl& gl, const scene::Scene& scene, IndexedVertices& ribbons);
///@}

/// Uploads opacities that a vertex has beside its colour's, `copies` times each, in [0, 1];
/// uploaded again they replace the old ones. Programs with the define OPTIMIZED_VERTICES read them.
void upload_opacities(const Gl& gl, std::span<const float> opacities, int copies,
                      IndexedVertices& vertices);
/// Uploads the importance of the scene's points, in [0, 1]: 4 bytes a point; 0 where an object has
/// none.
BufferTexture upload_disc_importance(const Gl& gl, const scene::Scene& scene);

}  // namespace pellucid::oit
