// SPDX-License-Identifier: GPL-3.0-or-later
// Ranges by percentiles are of a file's values, each once, however vertices repeat them.

#include <fmt/format.h>

#include <cmath>

#include "tests/scene/files/scene_file_folder.h"

namespace pellucid::scene {
namespace {

using namespace testing;

/// Ten triangles of 0, 1, … 9 and a polygon of 30 corners of 100.
std::string faces_ply() {
  std::string vertices, faces;
  for (int i = 0; i < 10; ++i) {
    vertices += fmt::format("{0} 0 0\n{1} 0 0\n{0} 1 0\n", 2 * i, 2 * i + 1);
    faces += fmt::format("3 {} {} {} {}\n", 3 * i, 3 * i + 1, 3 * i + 2, i);
  }
  std::string polygon = "30";
  for (int k = 0; k < 30; ++k) {
    const double angle = 0.2094 * k;
    vertices += fmt::format("{} {} 5\n", std::cos(angle), std::sin(angle));
    polygon += fmt::format(" {}", 30 + k);
  }
  return "ply\nformat ascii 1.0\nelement vertex 60\nproperty float x\nproperty float y\n"
         "property float z\nelement face 11\nproperty list uchar int vertex_indices\n"
         "property float s\nend_header\n" +
         vertices + faces + polygon + " 100\n";
}

class UnitFilePercentiles : public SceneFileTest {
 protected:
  void SetUp() override { std::ofstream(folder_ / "faces.ply") << faces_ply(); }

  static std::string object(const std::string& range) {
    return R"({"mesh": "faces.ply", "color": {"by": "s", "map": ["black", "white"], "range": )" +
           range + "}}";
  }
};

/// numpy.median([0, 1, …, 9, 100]) is 5; of the vertices it would be 54.5.
TEST_F(UnitFilePercentiles, AFaceCountsOnceWhateverItsCorners) {
  const Scene scene = with(object(R"(["0%", "50%"])"));
  const geometry::TriangleMesh& mesh = scene.objects.front().mesh();
  for (std::uint32_t i = 0; i < 10; ++i)
    EXPECT_FLOAT_EQ(mesh.colors[mesh.triangles[i][0]].r, std::min(0.2f * float(i), 1.f)) << i;
}

TEST_F(UnitFilePercentiles, AScalarCountsByTheFileThoughAnotherSplitsItsVertices) {
  std::ofstream(folder_ / "both.ply")
      << "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
         "property float z\nproperty float v\nelement face 4\n"
         "property list uchar int vertex_indices\nproperty float s\nend_header\n"
         "0 0 0 8\n1 0 0 0\n0 1 0 2\n-1 0 0 3\n0 -1 0 4\n"
         "3 0 1 2 1\n3 0 2 3 2\n3 0 3 4 3\n3 0 4 1 4\n";
  const Scene scene = with(
      R"({"mesh": "both.ply", "color": {"by": "s"},
          "opacity": {"by": "v", "opacities": [0, 1], "range": [0, "50%"]}})");
  // The median of 8, 0, 2, 3, 4 is 3, at vertex 3; four copies of vertex 0 and two of others make
  // more.
  const geometry::TriangleMesh& mesh = scene.objects.front().mesh();
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (mesh.positions[i] == Vec3(0, 1, 0)) {
      EXPECT_FLOAT_EQ(mesh.colors[i].a, 2.f / 3);
    }
}

}  // namespace
}  // namespace pellucid::scene
