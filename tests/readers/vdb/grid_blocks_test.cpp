// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vdb/grid_blocks.h"
#include "tests/support/memory_blocks.h"

#include <gmock/gmock.h>

#include <functional>

namespace pellucid::readers {
namespace {

using ::testing::HasSubstr;

std::vector<VdbGrid> through_blocks(const std::function<void(BlockWriter&)>& write) {
  return grids_of(testing::blocks_of(write));
}

class UnitGridBlocks : public ::testing::Test {
 protected:
  void SetUp() override { openvdb::initialize(); }
};

/// Leaves, active and inactive tiles of every level, and voxels that are off but have values.
template <class Grid>
void expect_same_after_blocks(const typename Grid::ValueType& background,
                              const typename Grid::ValueType& value) {
  const auto grid = Grid::create(background);
  grid->setName("velocity");
  grid->setGridClass(openvdb::GRID_STAGGERED);
  openvdb::Mat4d affine = openvdb::Mat4d::identity();
  affine[0][0] = 0.3;
  affine[1][0] = 7e-5;
  affine[3][2] = -1. / 3;
  grid->setTransform(openvdb::math::Transform::Ptr(new openvdb::math::Transform(
      openvdb::math::MapBase::Ptr(new openvdb::math::AffineMap(affine)))));
  grid->fill(openvdb::CoordBBox({-20, -20, -20}, {300, 40, 140}), value, true);
  grid->fill(openvdb::CoordBBox({0, 0, 0}, {31, 31, 31}), value, false);
  for (int i = -9; i < 9; ++i) grid->tree().setValueOn({i * 1000, i, i * i}, background + value);
  grid->tree().setValueOff({5000, 5, 5}, value);
  const auto written = grid->deepCopy();
  const auto copies = through_blocks([&](BlockWriter& out) { write_grid(0, *written, true, out); });
  ASSERT_EQ(copies.size(), 1u);
  EXPECT_EQ(copies[0].name, "velocity");
  EXPECT_EQ(copies[0].value_type, grid->valueType());
  const auto copy = openvdb::gridPtrCast<Grid>(copies[0].grid);
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->getGridClass(), openvdb::GRID_STAGGERED);
  EXPECT_EQ(affine_of(*copy), affine);
  EXPECT_EQ(copy->background(), background);
  EXPECT_EQ(copy->activeVoxelCount(), grid->activeVoxelCount());
  EXPECT_TRUE(copy->tree().hasSameTopology(grid->tree()));
  for (auto at = grid->cbeginValueAll(); at; ++at)
    ASSERT_EQ(copy->tree().getValue(at.getCoord()), at.getValue()) << at.getCoord();
}

/// More leaves than are made, and given back, at once.
TEST_F(UnitGridBlocks, ManyLeavesLoseNoValueWhereTheirMemoryGoesBack) {
  const auto grid = openvdb::DoubleGrid::create(-1);
  auto accessor = grid->getAccessor();
  for (int i = 0; i < 40000; ++i) accessor.setValue({8 * (i % 50), 8 * (i / 50), i % 8}, i + 0.5);
  ASSERT_EQ(grid->tree().leafCount(), 40000u);
  const auto copies = through_blocks([&](BlockWriter& out) { write_grid(0, *grid, true, out); });
  const auto copy = openvdb::gridPtrCast<openvdb::DoubleGrid>(copies.at(0).grid);
  EXPECT_EQ(copy->tree().leafCount(), 40000u);
  for (int i = 0; i < 40000; ++i) {
    const openvdb::Coord at(8 * (i % 50), 8 * (i / 50), i % 8);
    ASSERT_EQ(copy->tree().getValue(at), i + 0.5);
    ASSERT_EQ(copy->tree().getValue(at.offsetBy(1, 0, 0)), -1);
  }
}

TEST_F(UnitGridBlocks, KeepsEveryValueAndPlace) {
  expect_same_after_blocks<openvdb::FloatGrid>(0.25f, 1.5f);
  expect_same_after_blocks<openvdb::DoubleGrid>(0, 1. / 3);
  expect_same_after_blocks<openvdb::Vec3SGrid>({0, 0, 0}, {1, 2, 3});
  expect_same_after_blocks<openvdb::Vec3DGrid>({1, 0, 0}, {0.1, 0.2, 0.3});
}

TEST_F(UnitGridBlocks, OfOthersOnlyTheNameIsKept) {
  const auto grid = openvdb::FloatGrid::create();
  grid->setName("density");
  const auto mask = openvdb::BoolGrid::create();
  mask->setName("mask");
  const auto copies = through_blocks([&](BlockWriter& out) {
    write_grid(0, *grid, false, out);
    write_grid(1, *mask, true, out);
  });
  ASSERT_EQ(copies.size(), 2u);
  EXPECT_EQ(copies[0].grid, nullptr);
  EXPECT_EQ(copies[1].grid, nullptr);
  EXPECT_EQ(copies[0].name + copies[1].name, "densitymask");
  EXPECT_EQ(copies[1].value_type, "bool");
}

/// One leaf of zeros with this origin and so many values, and a tile.
std::string complaint_about(std::int32_t origin, std::size_t values, std::int32_t tile_level,
                            std::int32_t tile_place = 0) {
  try {
    through_blocks([&](BlockWriter& out) {
      const std::int32_t grid_class = 0, origins[] = {origin, 0, 0};
      const std::int32_t tile[] = {tile_level, 0, 0, tile_place, 1};
      const double affine[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      const std::uint64_t masks[8] = {};
      const std::vector<float> numbers(values);
      out.add_text("0.name", "p");
      out.add_text("0.type", openvdb::FloatGrid::gridType());
      out.add("0.class", std::span<const std::int32_t>(&grid_class, 1));
      out.add("0.affine", std::span<const double>(affine));
      out.add("0.background", std::span<const float>(numbers).first(1));
      out.add("0.origins", std::span<const std::int32_t>(origins), 3);
      out.add("0.masks", std::span<const std::uint64_t>(masks), 8);
      out.add("0.values", std::span<const float>(numbers));
      out.add("0.tiles", std::span<const std::int32_t>(tile), 5);
      out.add("0.tile_values", std::span<const float>(numbers).first(1));
    });
  } catch (const BlockError& error) {
    return error.what();
  }
  return "accepted";
}

TEST_F(UnitGridBlocks, WhatDoesNotFitIsRefused) {
  EXPECT_EQ(complaint_about(-8, 512, 1), "accepted");
  EXPECT_THAT(complaint_about(4, 512, 1), HasSubstr("off its lattice"));
  EXPECT_THAT(complaint_about(0, 511, 1), HasSubstr("do not fit"));
  EXPECT_THAT(complaint_about(0, 512, 0), HasSubstr("level 0"));
  EXPECT_THAT(complaint_about(0, 512, 9), HasSubstr("level 9"));
}

/// The width of a box of voxels has to be an int, and one beyond the last voxel, too.
TEST_F(UnitGridBlocks, WhatIsTooFarOutIsRefused) {
  const std::int32_t least = std::numeric_limits<std::int32_t>::min(), far = 1 << 30;
  EXPECT_THAT(complaint_about(std::numeric_limits<std::int32_t>::max() - 7, 512, 1),
              HasSubstr("leaf 0 is at voxel 2147483640"));
  EXPECT_THAT(complaint_about(least, 512, 1), HasSubstr("leaf 0 is at voxel -2147483648"));
  EXPECT_THAT(complaint_about(0, 512, 1, far), HasSubstr("tile 0 is at voxel 1073741824"));
  EXPECT_THAT(complaint_about(0, 512, 1, least), HasSubstr("tile 0 is at voxel -2147483648"));
  EXPECT_EQ(complaint_about(far - 4096, 512, 3, 4096 - far), "accepted");
}

/// A grid that says it holds vectors, but is one of floats, would be taken for vectors.
TEST_F(UnitGridBlocks, TheGridItselfSaysWhatItHolds) {
  const auto grid = openvdb::FloatGrid::create();
  const auto copies = through_blocks([&](BlockWriter& out) {
    out.add_text("0.value", "vec3s");
    write_grid(0, *grid, true, out);
  });
  ASSERT_EQ(copies.size(), 1u);
  EXPECT_EQ(copies[0].value_type, "float");
  EXPECT_FALSE(holds_vectors(copies[0]));
}

}  // namespace
}  // namespace pellucid::readers
