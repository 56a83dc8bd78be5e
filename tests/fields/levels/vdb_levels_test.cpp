// SPDX-License-Identifier: GPL-3.0-or-later
// Levels from OpenVDB files: what they hold, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/error.h"
#include "fields/levels/surface_cells.h"
#include "fields/levels/vdb_levels.h"
#include "fields/readers/vdb_field.h"
#include "readers/vdb/grid_blocks.h"
#include "tests/fields/levels/vdb_refusal.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using openvdb::math::Transform;
using ::testing::HasSubstr;
using testing::read_float_levels;
using testing::refusal;

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

TEST(UnitVdbLevels, EveryGridOfTheNameIsALevel) {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string())
      .write({scalar_grid("p", 4, 0.5), scalar_grid("p", 5, 0.25), scalar_grid("other", 3, 1)});
  const auto levels = read_float_levels(folder / "levels.vdb", "p");
  ASSERT_EQ(levels.size(), 2u);
  const ScalarLevel& level = levels[0].size[0] == 4 ? levels[0] : levels[1];
  EXPECT_EQ(level.width, 0.5);
  EXPECT_EQ(level.origin, Vec3(1, 1.5, 2));
  EXPECT_EQ(level.at(3, 1, 2), float(2.5 + 10 * 2));
}

/// A box of 24³ equal voxels, which OpenVDB prunes to tiles, and a bump in its middle.
TEST(UnitVdbLevels, TilesOfAFullBoxAreRead) {
  openvdb::initialize();
  const auto grid = openvdb::FloatGrid::create(99);
  grid->setName("p");
  grid->denseFill({{0, 0, 0}, {23, 23, 23}}, 5);
  grid->tree().touchLeaf({12, 12, 12});
  grid->getAccessor().setValueOn({12, 12, 12}, 7);
  grid->pruneGrid();
  ASSERT_GT(grid->tree().activeTileCount(), 0u);
  const TemporaryFolder folder;
  openvdb::io::File((folder / "tiles.vdb").string()).write({grid});
  const ScalarLevel level = read_float_levels(folder / "tiles.vdb", "p").at(0);
  EXPECT_EQ(level.size, (std::array{24, 24, 24}));
  for (int i = 0; i < 24; ++i) EXPECT_EQ(level.at(i, 12, 12), i == 12 ? 7 : 5);
  EXPECT_EQ(level.at(0, 0, 23), 5);
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
    EXPECT_THROW(read_float_levels(folder / "cut.vdb", "p"), InputError) << length;
  }
  EXPECT_THROW(read_float_levels(folder / "missing.vdb", "p"), InputError);
}

TEST(UnitVdbLevels, MutatedFilesAreRefusedOrWhole) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "needs std::bad_alloc";
#endif
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string())
      .write({scalar_grid("p", 8, 1), scalar_grid("p", 5, 0.5)});
  const std::string bytes = read_bytes(folder / "levels.vdb");
  std::mt19937_64 random(5);
  int refused = 0;
  for (int round = 0; round < 50; ++round) {
    std::string mutated = bytes;
    const std::size_t where = round % 2 ? bytes.size() : std::min<std::size_t>(bytes.size(), 900);
    for (int i = 0; i < 3; ++i) mutated[random() % where] = char(random() % 256);
    write_bytes(folder / "mutated.vdb", mutated);
    try {
      for (const ScalarLevel& level : read_float_levels(folder / "mutated.vdb", "p"))
        check_level("level", level);
    } catch (const InputError& error) {
      ++refused;
      EXPECT_THAT(error.what(), HasSubstr("mutated.vdb"));
      EXPECT_THAT(error.what(), ::testing::Not(HasSubstr("\n")));
    }
  }
  EXPECT_GT(refused, 7);
}

template <class T>
void expect_same(const Level<T>& a, const Level<T>& b) {
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.size, b.size);
  EXPECT_EQ(a.samples, b.samples);
}

TEST(UnitVdbLevels, WhatIsWrittenIsReadBitForBit) {
  const TemporaryFolder folder;
  // Widths and origins that are no binary fractions, a constant level, -0 and the smallest numbers.
  const auto wave = [](const Vec3& x) { return std::sin(3 * x.x) * std::exp(x.y) - x.z; };
  std::vector<ScalarLevel> levels{
      testing::sampled(Vec3(0.1, -0.7, 1e5), 0.3, {9, 17, 4}, wave),
      testing::sampled(Vec3(1e-3), 0.1, 8, [](const Vec3&) { return 0.0; }),
      testing::sampled(Vec3(-1), 7e-5, 3, wave)};
  levels[0].samples[5] = -0.0f;
  levels[0].samples[6] = std::numeric_limits<float>::denorm_min();
  write_vdb_levels(folder / "p.vdb", "p", std::span<const ScalarLevel>(levels));
  const auto read = read_float_levels(folder / "p.vdb", "p");
  ASSERT_EQ(read.size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) expect_same(read[i], levels[i]);
  EXPECT_TRUE(std::signbit(read[0].samples[5]));
}

TEST(UnitVdbLevels, WhatCannotBeWrittenLeavesNothing) {
  const TemporaryFolder folder;
  std::vector levels{testing::sampled(Vec3(0), 1, 3, [](const Vec3&) { return 1.0; })};
  const auto write = [&](const char* name) {
    write_vdb_levels(folder / name, "p", std::span<const ScalarLevel>(levels));
  };
  EXPECT_THROW(write("p.ply"), InputError);
  EXPECT_THROW(write("none/p.vdb"), InputError);
  levels[0].samples[3] = NAN;
  EXPECT_THROW(write("p.vdb"), InputError);
  levels.clear();
  EXPECT_THROW(write("p.vdb"), InputError);
  EXPECT_TRUE(std::filesystem::is_empty((folder / "p").parent_path()));
}

}  // namespace
}  // namespace pellucid::fields
