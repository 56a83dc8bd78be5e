// SPDX-License-Identifier: GPL-3.0-or-later
// Normals of a file have any length, and unit length once read: across a face a longer one would
// weigh more, so that one mesh would be lit in as many ways as there are formats.

#include "geometry/vertex_normals.h"
#include "tests/geometry/files/format_files.h"

namespace pellucid::geometry {
namespace {

using ::testing::ElementsAre;
using UnitNormals = FormatFiles;

/// One triangle with the normals (0, 0, 10), (3, 0, 4) and (0, 0.5, 0) in every format that has
/// normals.
std::vector<std::pair<std::string, std::string>> lit_triangles() {
  const std::string gltf_bytes =
      bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 10, 3, 0, 4, 0, 0.5f, 0});
  return {
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 10\nvn 3 0 4\nvn 0 0.5 0\nf 1//1 2//2 3//3\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
       "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
       "0 0 0 0 0 10\n1 0 0 3 0 4\n0 1 0 0 0.5 0\n3 0 1 2\n"},
      {"a.off", "NOFF 3 1 0\n0 0 0 0 0 10\n1 0 0 3 0 4\n0 1 0 0 0.5 0\n3 0 1 2\n"},
      {"a.vtk",
       "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
       "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nNORMALS n float\n"
       "0 0 10 3 0 4 0 0.5 0\n"},
      {"a.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "a.bin", "byteLength": 72}],
        "bufferViews": [{"buffer": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 36}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}}]}]})"},
      {"a.bin", gltf_bytes}};
}

TEST_F(UnitNormals, AreOfUnitLengthInEveryFormat) {
  for (const auto& [name, content] : lit_triangles()) file(name, content);
  for (const auto& [name, content] : lit_triangles()) {
    if (name.ends_with(".bin")) continue;
    EXPECT_THAT(read_mesh(folder_ / name).normals,
                ElementsAre(Vec3(0, 0, 1), Vec3(0.6, 0, 0.8), Vec3(0, 1, 0)))
        << name;
  }
}

TEST_F(UnitNormals, OfPointsAndLinesAreSoToo) {
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
      "property int line\nend_header\n0 0 0 0 0 10 0\n1 0 0 0 0 0 0\n";
  const auto unit = ElementsAre(Vec3(0, 0, 1), Vec3(0));
  EXPECT_THAT(read_points(file("a.ply", head)).normals, unit);
  EXPECT_THAT(read_lines(folder_ / "a.ply").normals, unit);
}

// The lengths' squares go beyond what a double holds, or vanish.
TEST_F(UnitNormals, AreRightAtAnyScale) {
  for (const double scale : {1.0, 1e-150, 1e-250, 1e80, 1e160, 1e250}) {
    TriangleMesh mesh;
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 3, 4)})
      mesh.positions.push_back(scale * x);
    mesh.triangles = {{0, 1, 2}};
    for (const Vec3& normal : facet_normals(mesh))
      EXPECT_LE(glm::length(normal - Vec3(0, -0.8, 0.6)), 1e-15) << scale;
    mesh.normals = {scale * Vec3(3, 0, 4), scale * Vec3(0, 0, 1), Vec3(0)};
    EXPECT_EQ(mend_normals(mesh), 1u) << scale;
    EXPECT_LE(glm::length(mesh.normals[0] - Vec3(0.6, 0, 0.8)), 1e-15) << scale;
    EXPECT_LE(glm::length(mesh.normals[2] - Vec3(0, -0.8, 0.6)), 1e-15) << scale;
  }
}

}  // namespace
}  // namespace pellucid::geometry
