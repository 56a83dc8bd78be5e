// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/finite_vertices.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"
#include "geometry/files/mesh_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::geometry {
namespace {

/// Calls write(name) for a file, and expects a refusal of one line and no file.
template <class Write>
void expect_refused(const testing::TemporaryFolder& folder, const char* name, const Write& write) {
  const auto path = folder / name;
  try {
    write(path);
    ADD_FAILURE() << name;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("vertex 1 came out at (0, nan, 0)"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(path.string()));
  }
  EXPECT_FALSE(std::filesystem::exists(path)) << name;
}

TEST(UnitFiniteVertices, NoWriterWritesOthers) {
  const testing::TemporaryFolder folder;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Vec3> positions{{0, 0, 0}, {0, nan, 0}, {1, 1, 0}};
  TriangleMesh mesh;
  mesh.positions = positions;
  mesh.triangles = {{0, 1, 2}};
  LineSet lines;
  lines.positions = positions;
  lines.offsets = {0, 3};
  PointSet points;
  points.positions = positions;
  for (const char* name : {"mesh.ply", "mesh.obj", "mesh.vtp"})
    expect_refused(folder, name, [&](const auto& path) { write_mesh(path, mesh); });
  for (const char* name : {"lines.ply", "lines.vtp"})
    expect_refused(folder, name, [&](const auto& path) { write_lines(path, lines); });
  for (const char* name : {"points.ply", "points.vtp"})
    expect_refused(folder, name, [&](const auto& path) { write_points(path, points); });
}

}  // namespace
}  // namespace pellucid::geometry
