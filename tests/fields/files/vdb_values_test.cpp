// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/vdb_values.h"

#include <gtest/gtest.h>

namespace pellucid::fields {
namespace {

const auto itself = [](float value) { return value; };

/// Leaves with voxels on and off, tiles of two sizes, and the background, on both sides of 0.
openvdb::FloatGrid::Ptr mixed_grid() {
  openvdb::initialize();
  const auto grid = openvdb::FloatGrid::create(-3);
  grid->fill(openvdb::CoordBBox({-16, -8, 0}, {7, 15, 7}), 5, true);       // tiles of 8³
  grid->fill(openvdb::CoordBBox({128, 0, 0}, {255, 127, 127}), 7, false);  // and of 128³
  auto accessor = grid->getAccessor();
  for (int i = 0; i < 500; ++i) accessor.setValue({i % 37 - 20, i % 23 - 9, i % 19 - 11}, i + 0.5f);
  return grid;
}

std::vector<float> one_by_one(const openvdb::FloatGrid& grid, const openvdb::CoordBBox& box) {
  std::vector<float> values;
  const auto accessor = grid.getConstAccessor();
  for (int k = box.min().z(); k <= box.max().z(); ++k)
    for (int j = box.min().y(); j <= box.max().y(); ++j)
      for (int i = box.min().x(); i <= box.max().x(); ++i)
        values.push_back(accessor.getValue({i, j, k}));
  return values;
}

TEST(UnitVdbValues, AreThoseOfEveryVoxelOfAnyBox) {
  const auto grid = mixed_grid();
  for (const openvdb::CoordBBox& box :
       {openvdb::CoordBBox({-21, -13, -12}, {140, 30, 21}),
        openvdb::CoordBBox({-16, -8, 0}, {7, 15, 7}), openvdb::CoordBBox({3, 3, 3}, {3, 3, 3}),
        openvdb::CoordBBox({-9, 7, -1}, {0, 8, 9})})
    EXPECT_EQ(values_in(*grid, box, GridUse::kept, itself), one_by_one(*grid, box)) << box;
  EXPECT_FALSE(grid->empty());
}

/// So many leaves that memory goes back while others are still to be copied: 128 MiB.
TEST(UnitVdbValues, OfAGridThatIsEmptiedTheyAreTheSame) {
  openvdb::initialize();
  const auto grid = openvdb::FloatGrid::create(0);
  const openvdb::CoordBBox box({-128, -128, 1}, {127, 127, 512});
  for (int k = 1; k <= 512; k += 8)
    grid->fill(openvdb::CoordBBox({-128, -128, k}, {127, 127, k + 7}), float(k), true);
  grid->tree().voxelizeActiveTiles();
  const std::vector<float> values = values_in(*grid, box, GridUse::emptied, itself);
  ASSERT_EQ(values.size(), std::size_t(1) << 25);
  for (std::size_t i = 0; i < values.size(); ++i)
    ASSERT_EQ(values[i], float(1 + (i >> 16) / 8 * 8)) << i;
  EXPECT_TRUE(grid->empty());
}

TEST(UnitVdbValues, AreWhatIsMadeOfThem) {
  openvdb::initialize();
  const auto grid = openvdb::Vec3SGrid::create({1, 2, 3});
  grid->tree().setValueOn({0, 0, 0}, {4, 5, 6});
  const auto sums = values_in(*grid, openvdb::CoordBBox({0, 0, 0}, {1, 0, 0}), GridUse::kept,
                              [](const openvdb::Vec3s& v) { return double(v[0] + v[1] + v[2]); });
  EXPECT_EQ(sums, (std::vector<double>{15, 6}));
}

}  // namespace
}  // namespace pellucid::fields
