// Levels from OpenVDB files: what they hold, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "fields/sphere_levels.h"
#include "fields/vdb_levels.h"
#include "tests/fields/grid_files.h"

namespace pellucid {
namespace {

using openvdb::math::Transform;
using ::testing::HasSubstr;

/// n³ voxels from (2, 3, 4) on, f = x + 10 y in world coordinates, cells of `width`.
openvdb::FloatGrid::Ptr scalar_grid(const std::string& name, int n, double width) {
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(99);  // a background that would show
  grid->setName(name);
  grid->setTransform(Transform::createLinearTransform(width));
  auto accessor = grid->getAccessor();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        accessor.setValueOn({i + 2, j + 3, k + 4}, float(width * (i + 2) + 10 * width * (j + 3)));
  return grid;
}

std::string refusal(const openvdb::GridBase::Ptr& grid, std::string_view scalar = "p") {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write({grid});
  try {
    read_vdb_levels(folder / "levels.vdb", scalar);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(UnitVdbLevels, EveryGridOfTheNameIsALevel) {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string())
      .write({scalar_grid("p", 4, 0.5), scalar_grid("p", 5, 0.25), scalar_grid("other", 3, 1)});
  const auto levels = read_vdb_levels(folder / "levels.vdb", "p");
  ASSERT_EQ(levels.size(), 2u);
  const ScalarLevel& level = levels[0].size[0] == 4 ? levels[0] : levels[1];
  EXPECT_EQ(level.width, 0.5);
  EXPECT_EQ(level.origin, Vec3(1, 1.5, 2));
  EXPECT_EQ(level.at(3, 1, 2), float(2.5 + 10 * 2));
}

TEST(UnitVdbLevels, BadGridsAreRefused) {
  EXPECT_EQ(refusal(scalar_grid("p", 3, 1)), "");
  EXPECT_THAT(refusal(openvdb::FloatGrid::create()), HasSubstr("no grid has the scalar 'p'"));
  EXPECT_THAT(refusal(scalar_grid("p", 3, 1), "q"), HasSubstr("p (float)"));
  EXPECT_THAT(refusal(scalar_grid("p", 1, 1)), HasSubstr("at least 3 along each axis"));
  auto grid = scalar_grid("p", 4, 1);
  grid->getAccessor().setValueOn({3, 4, 5}, std::numeric_limits<float>::quiet_NaN());
  EXPECT_THAT(refusal(grid), HasSubstr("is not finite"));
  grid = scalar_grid("p", 4, 1);
  grid->getAccessor().setValueOn({40, 4, 5}, 1);
  EXPECT_THAT(refusal(grid), HasSubstr("do not fill a box"));
  auto empty = openvdb::FloatGrid::create();
  empty->setName("p");
  EXPECT_THAT(refusal(empty), HasSubstr("no active voxels"));
}

TEST(UnitVdbLevels, VoxelsThatAreNoCubesAlongTheAxesAreRefused) {
  auto grid = scalar_grid("p", 4, 1);
  grid->transform().preScale(openvdb::Vec3d(1, 2, 1));
  EXPECT_THAT(refusal(grid), HasSubstr("not cubes along the axes"));
  grid = scalar_grid("p", 4, 1);
  grid->transform().preRotate(0.1);
  EXPECT_THAT(refusal(grid), HasSubstr("not cubes along the axes"));
}

TEST(UnitVdbLevels, TruncatedFilesAreRefused) {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write({scalar_grid("p", 8, 1)});
  const std::string bytes = read_bytes(folder / "levels.vdb");
  for (std::size_t length = 0; length + 64 < bytes.size(); length += bytes.size() / 23) {
    write_bytes(folder / "cut.vdb", std::string_view(bytes).substr(0, length));
    EXPECT_THROW(read_vdb_levels(folder / "cut.vdb", "p"), InputError) << length;
  }
  EXPECT_THROW(read_vdb_levels(folder / "missing.vdb", "p"), InputError);
}

TEST(UnitSphereLevels, AreNested) {
  const auto levels = make_sphere_levels("sphere-levels");
  ASSERT_EQ(levels.size(), 4u);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    EXPECT_EQ(levels[i].width, levels[i - 1].width / 2);
    const Box3 outer = levels[i - 1].box(0.5), inner = levels[i].box(0.5);
    EXPECT_TRUE(outer.contains(inner.min) && outer.contains(inner.max));
  }
  EXPECT_THROW(make_sphere_levels("sphere-levels:levels=5"), InputError);
  EXPECT_THROW(make_sphere_levels("cube-levels"), InputError);
}

}  // namespace
}  // namespace pellucid
