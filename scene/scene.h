#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/triangle_mesh.h"
#include "scene/camera.h"

namespace pellucid {

enum class Lighting {
  none,      // a fragment has the interpolated colour of its vertices
  headlight  // times |n · v|, two-sided diffuse with the light at the eye
};

/// One thing of the scene, ready to be drawn: colours are always filled in, normals where the scene
/// is lit.
struct SceneObject {
  std::string name;  // where it comes from, for messages and the report
  TriangleMesh mesh;
};

/// What is drawn and how. Objects are ordered: crossings at equal depth are ordered by object, then
/// by triangle.
struct Scene {
  std::string name;
  int width = 1000;
  int height = 1000;
  Camera camera;
  Vec3 background{1, 1, 1};
  Lighting lighting = Lighting::none;
  std::vector<SceneObject> objects;
  std::map<std::string, std::string> provenance;  // how the objects were made

  Box3 bounds() const {
    Box3 box;
    for (const SceneObject& object : objects)
      for (const Vec3& x : object.mesh.positions) box.extend(x);
    return box;
  }
  std::size_t triangle_count() const {
    std::size_t count = 0;
    for (const SceneObject& object : objects) count += object.mesh.triangles.size();
    return count;
  }
};

}  // namespace pellucid
