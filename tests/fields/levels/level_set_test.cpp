// SPDX-License-Identifier: GPL-3.0-or-later
// Level sets: surfaces within the narrow band, and values of which there is none.

#include <gmock/gmock.h>
#include <openvdb/openvdb.h>

#include <cmath>

#include "fields/levels/surface_cells.h"
#include "fields/levels/vdb_levels.h"
#include "readers/vdb/grid_blocks.h"
#include "tests/fields/levels/vdb_refusal.h"

namespace pellucid::fields {
namespace {

using openvdb::math::Transform;
using ::testing::HasSubstr;
using testing::read_float_levels;
using testing::refusal;

/// A ball of radius 1 about the origin in a band of three voxels on either side.
openvdb::FloatGrid::Ptr ball() {
  constexpr double width = 0.1, band = 0.3;
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(band);
  grid->setName("ball");
  grid->setTransform(Transform::createLinearTransform(width));
  auto accessor = grid->getAccessor();
  for (int k = -14; k <= 14; ++k)
    for (int j = -14; j <= 14; ++j)
      for (int i = -14; i <= 14; ++i) {
        const double distance = width * std::sqrt(double(i * i + j * j + k * k)) - 1;
        if (std::abs(distance) < band) accessor.setValueOn({i, j, k}, float(distance));
        if (distance <= -band) accessor.setValueOff({i, j, k}, -float(band));
      }
  return grid;
}

TEST(UnitLevelSets, ALevelSetIsTheBoxAroundItsBand) {
  const auto grid = ball();
  EXPECT_THAT(refusal(grid, "ball"), HasSubstr("do not fill a box"));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write({grid});
  const auto levels = read_float_levels(folder / "levels.vdb", "ball");
  ASSERT_EQ(levels.size(), 1u);
  const LevelField field(levels, find_reconstruction("trilinear"));
  EXPECT_NEAR(*field.value(Vec3(0)), -0.3, 1e-7);
  // Between samples of a sphere's distance: a width² / 8 over the radius, in three directions.
  EXPECT_NEAR(*field.value(Vec3(0.64, 0.48, 0.6)), 0, 3 * 0.01 / 8);
  EXPECT_NEAR(*field.value(Vec3(1.1, 1.1, 1.1)), 0.3, 1e-7);
}

/// Around the band 0.3 stands for all that is farther: a surface there would be none of the data's.
TEST(UnitLevelSets, TheRangeOfALevelSetIsThatOfItsBand) {
  const auto grid = ball();
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const std::vector<readers::VdbGrid> grids{{.name = "ball", .value_type = "float", .grid = grid}};
  const auto levels = levels_of(grids, "ball.vdb", "ball");
  const Vec2 range = value_range(grids, "ball", levels);
  EXPECT_LT(range.y, 0.3f);  // of the farthest voxel within it, a width of 0.1 nearer at most
  EXPECT_GT(range.y, 0.2f);
  EXPECT_EQ(range.x, float(0.1 * 7 - 1));  // the voxel that is 7 off the centre along an axis
  EXPECT_EQ(sample_range(levels), Vec2(float(-0.3), float(0.3)));
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);  // of which 0.3 is the value all around
  EXPECT_EQ(value_range(grids, "ball", levels), sample_range(levels));
}

/// Whether every corner of the cells that the surface passes has the ball's distance.
bool has_distances_around(const LevelField& field, double value) {
  const ScalarLevel& level = field.levels().front();
  for (const LatticeCell& cell : surface_cells(field, value))
    for (int corner = 0; corner < 8; ++corner) {
      const int i = cell.low[0] + (corner & 1), j = cell.low[1] + (corner >> 1 & 1),
                k = cell.low[2] + (corner >> 2);
      const double distance = glm::length(level.world(Vec3(i, j, k))) - 1;
      if (std::abs(level.at(i, j, k) - distance) > 1e-6) return false;
    }
  return true;
}

/// Of 601 values all told: the band's own samples reach beyond the values whose cells they fill.
TEST(UnitLevelSets, ASurfaceOfALevelSetPassesActiveVoxelsAlone) {
  const auto grid = ball();
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const std::vector<readers::VdbGrid> grids{{.name = "ball", .value_type = "float", .grid = grid}};
  const ExactLevels levels = levels_of(grids, "ball.vdb", "ball");
  const LevelField field(std::get<0>(levels), find_reconstruction("trilinear"));
  const ValueGaps gaps = value_gaps(grids, "ball");
  const Vec2 range = value_range(grids, "ball", levels);
  int accepted = 0, refused = 0;
  for (int i = -300; i <= 300; ++i) {
    const double value = i * 1e-3 + 3e-5;  // at no sample
    if (value < range.x || value > range.y) continue;
    EXPECT_EQ(has_distances_around(field, value), !gaps.contains(value)) << value;
    ++(gaps.contains(value) ? refused : accepted);
  }
  // A cell's diagonal is 0.17 long: within 0.3 - 0.17 on either side no cell leaves the band.
  EXPECT_GT(accepted, 2 * 130 - 1);
  EXPECT_GT(refused, 100);
  EXPECT_FALSE(gaps.contains(0));
  EXPECT_THAT(gaps.accepted(range), ::testing::MatchesRegex("above -0\\.1[0-9]+ to 0\\.1[0-9]+"));
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  EXPECT_TRUE(value_gaps(grids, "ball").empty());
}

/// Around a fog there is none: its surface of any value is closed, also where the outermost of its
/// active voxels are denser.
TEST(UnitLevelSets, AFogEndsInTheVoxelsAroundIt) {
  const auto fog = openvdb::FloatGrid::create(0);
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  auto voxels = fog->getAccessor();
  constexpr int half = 3;
  for (int k = -half; k <= half; ++k)
    for (int j = -half; j <= half; ++j)
      for (int i = -half; i <= half; ++i) voxels.setValueOn({i, j, k}, 1);
  const std::vector<readers::VdbGrid> grids{{.name = "fog", .value_type = "float", .grid = fog}};
  const auto levels = std::get<0>(levels_of(grids, "fog.vdb", "fog"));
  ASSERT_EQ(levels.size(), 1u);
  const ScalarLevel& level = levels[0];
  EXPECT_EQ(level.size, (std::array{9, 9, 9}));
  EXPECT_EQ(level.origin, Vec3(-4));
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i) {
        const int least = std::min({i, j, k}), most = std::max({i, j, k});
        EXPECT_EQ(level.at(i, j, k), least == 0 || most == 8 ? 0 : 1);
      }
}

}  // namespace
}  // namespace pellucid::fields
