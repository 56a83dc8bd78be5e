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
#include "tests/fields/readers/grid_files.h"
#include "tests/support/levels.h"

namespace pellucid::fields {
namespace {

using openvdb::math::Transform;
using ::testing::HasSubstr;
using testing::read_float_levels;

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
    read_float_levels(folder / "levels.vdb", scalar);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
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

/// n³ voxels of a rotation about z with this speed.
openvdb::Vec3SGrid::Ptr vector_grid(const std::string& name, int n, float speed) {
  openvdb::initialize();
  auto grid = openvdb::Vec3SGrid::create();
  grid->setName(name);
  auto accessor = grid->getAccessor();
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        accessor.setValueOn({i, j, k}, openvdb::Vec3s(-speed * float(j), speed * float(i), 0));
  return grid;
}

std::vector<ScalarLevel> magnitudes(const openvdb::GridPtrVec& grids,
                                    const std::string& velocity = {}) {
  const TemporaryFolder folder;
  openvdb::io::File((folder / "levels.vdb").string()).write(grids);
  return read_float_levels(folder / "levels.vdb", "magnitude", velocity);
}

TEST(UnitVdbLevels, OneOfSeveralVectorGridsIsTheVelocity) {
  const auto velocity = vector_grid("vel", 4, 1), color = vector_grid("Cd", 4, 7);
  for (const auto& grids : {openvdb::GridPtrVec{velocity, color}, {color, velocity}}) {
    const auto levels = magnitudes(grids);
    ASSERT_EQ(levels.size(), 1u);
    EXPECT_EQ(levels.front().at(3, 0, 0), 3);
    EXPECT_EQ(magnitudes(grids, "Cd").front().at(3, 0, 0), 21);
  }
  EXPECT_EQ(magnitudes({color}).front().at(3, 0, 0), 21);  // the only one, whatever its name
  EXPECT_EQ(magnitudes({velocity, vector_grid("vel", 5, 2)}).size(), 2u);  // levels of one name
}

/// u = x at the voxels' lower faces: where it belongs, |v| is x at their middles.
template <class Grid>
typename Grid::Ptr staggered_grid() {
  openvdb::initialize();
  auto grid = Grid::create(typename Grid::ValueType(99));  // a background that would show
  grid->setName("v");
  grid->setTransform(Transform::createLinearTransform(0.5));
  grid->setGridClass(openvdb::GRID_STAGGERED);
  auto accessor = grid->getAccessor();
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 6; ++j)
      for (int i = 0; i < 6; ++i)
        accessor.setValueOn({i, j, k}, typename Grid::ValueType(0.5 * (i + 1.5), 2, -1));
  return grid;
}

TEST(UnitVdbLevels, StaggeredVelocitiesBelongToTheMiddlesOfVoxels) {
  for (const openvdb::GridBase::Ptr& grid :
       {openvdb::GridBase::Ptr(staggered_grid<openvdb::Vec3SGrid>()),
        openvdb::GridBase::Ptr(staggered_grid<openvdb::Vec3DGrid>())}) {
    const std::vector<readers::VdbGrid> grids{
        {.name = "v", .value_type = grid->valueType(), .grid = grid}};
    const auto levels = rounded(levels_of(grids, "v.vdb", "magnitude"), 0);
    const ScalarLevel& level = levels.levels.front();
    EXPECT_EQ(level.size, (std::array{5, 5, 5}));  // the last voxels have one face alone
    EXPECT_EQ(level.origin, Vec3(0));
    for (int i = 0; i < 5; ++i)
      EXPECT_FLOAT_EQ(float(levels.scale.value(level.at(i, 2, 3))),
                      float(glm::length(Vec3(0.5 * (i + 2), 2, -1))));
    EXPECT_THROW(field_of(grids, {}, "v.vdb"), InputError);  // a velocity's faces are asked for
    FileOptions averaged;
    averaged.average_faces = true;
    const auto field = field_of(grids, averaged, "v.vdb");
    EXPECT_EQ(field->domain().max, Vec3(2));
    Vec3 v;
    ASSERT_EQ(field->sampler()->velocity(Vec3(1.3, 0.7, 2), 0, v), SampleStatus::ok);
    EXPECT_LT(glm::length(v - Vec3(2.3, 2, -1)), 1e-6);
  }
}

TEST(UnitVdbLevels, StaggeredVelocitiesOfOneLayerAreRefused) {
  auto grid = openvdb::Vec3SGrid::create();
  grid->setName("v");
  grid->setGridClass(openvdb::GRID_STAGGERED);
  grid->denseFill({{0, 0, 0}, {5, 5, 0}}, openvdb::Vec3s(1));
  EXPECT_THAT(refusal(grid, "magnitude"), HasSubstr("no voxel has both faces across every axis"));
  grid->sparseFill({{0, 0, 0}, {511, 511, 511}}, openvdb::Vec3s(1));  // 64 tiles of 128³
  EXPECT_THAT(refusal(grid, "magnitude"), HasSubstr("tiles of more than 2^24 voxels"));
}

TEST(UnitVdbLevels, WhichGridIsTheVelocityIsAsked) {
  const auto refusal_of = [](const openvdb::GridPtrVec& grids, const std::string& velocity) {
    try {
      magnitudes(grids, velocity);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const openvdb::GridPtrVec both{vector_grid("Cd", 4, 1), vector_grid("wind", 4, 1)};
  EXPECT_THAT(refusal_of(both, ""), HasSubstr("vector grids: Cd, wind"));
  EXPECT_THAT(refusal_of(both, "vel"), HasSubstr("'vel': no such grid; vector grids: Cd, wind"));
  EXPECT_EQ(refusal_of(both, "wind"), "");
}

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

TEST(UnitVdbLevels, ALevelSetIsTheBoxAroundItsBand) {
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
TEST(UnitVdbLevels, TheRangeOfALevelSetIsThatOfItsBand) {
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
TEST(UnitVdbLevels, ASurfaceOfALevelSetPassesActiveVoxelsAlone) {
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

}  // namespace
}  // namespace pellucid::fields
