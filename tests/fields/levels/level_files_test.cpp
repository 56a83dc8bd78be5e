// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_files.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;

const Axes cubes{evenly(-1, 0.5, 5), evenly(2, 0.5, 4), evenly(0, 0.5, 6)};
double slope(const Vec3& x) { return x.x + 10 * x.y + 100 * x.z; }

class UnitLevelFiles : public ::testing::Test {
 protected:
  std::vector<ScalarLevel> read(const std::string& text, std::string_view scalar,
                                const std::string& velocity = {}) {
    write_bytes(folder_ / "l.vtr", text);
    return read_levels(folder_ / "l.vtr", scalar, velocity).levels;
  }
  std::string complaint(const std::string& text, std::string_view scalar) {
    try {
      read(text, scalar);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  TemporaryFolder folder_;
};

void expect_slope(const ScalarLevel& level) {
  for (int k = 0; k < level.size[2]; ++k)
    for (int j = 0; j < level.size[1]; ++j)
      for (int i = 0; i < level.size[0]; ++i)
        EXPECT_FLOAT_EQ(level.at(i, j, k), float(slope(level.world(Vec3(i, j, k)))));
}

TEST_F(UnitLevelFiles, ScalarsOfPoints) {
  const auto levels = read(rectilinear(cubes, scalars("p", crossings(cubes), slope)), "p");
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_EQ(levels[0].size, (std::array{5, 4, 6}));
  EXPECT_EQ(levels[0].origin, Vec3(-1, 2, 0));
  EXPECT_DOUBLE_EQ(levels[0].width, 0.5);
  expect_slope(levels[0]);
}

TEST_F(UnitLevelFiles, ScalarsOfCellsAreInTheirMiddle) {
  const auto levels =
      read(rectilinear(cubes, {}, scalars("p", crossings(middles(cubes)), slope)), "p");
  EXPECT_EQ(levels[0].size, (std::array{4, 3, 5}));
  EXPECT_EQ(levels[0].origin, Vec3(-0.75, 2.25, 0.25));
  expect_slope(levels[0]);
}

TEST_F(UnitLevelFiles, ScalarsThatAreDerived) {
  const auto turning = [](const Vec3& x) { return Vec3(-x.y, x.x, 0); };
  const std::string text = rectilinear(
      cubes, vectors("U", crossings(cubes), turning) + vectors("B", crossings(cubes), turning));
  const auto levels = read(text, "magnitude", "U");
  EXPECT_FLOAT_EQ(levels[0].at(0, 0, 0), float(std::sqrt(5.0)));  // at (-1, 2)
  EXPECT_THAT(complaint(text, "magnitude"), HasSubstr("which vectors?"));
}

TEST_F(UnitLevelFiles, WhatIsNoGridOfCubesIsRefused) {
  Axes flat = cubes;
  flat[2] = evenly(0, 0.25, 6);
  EXPECT_THAT(complaint(rectilinear(flat, scalars("p", crossings(flat), slope)), "p"),
              HasSubstr("0.5 × 0.5 × 0.25; accepted: cubes. ParaView: Resample To Image"));
  Axes uneven = cubes;
  uneven[0] = {-1, -0.5, 0, 0.6};
  EXPECT_THAT(complaint(rectilinear(uneven, scalars("p", crossings(uneven), slope)), "p"),
              HasSubstr("its spacing along x is not even"));
  write_bytes(folder_ / "l.vts", structured(cubes, scalars("p", crossings(cubes), slope)));
  EXPECT_THROW(read_levels(folder_ / "l.vts", "p"), InputError);
  EXPECT_THAT(complaint(rectilinear(cubes, scalars("p", crossings(cubes), slope)), "q2"),
              HasSubstr("no array is the scalar 'q2'; arrays: p (point, 1 component, "));
}

TEST_F(UnitLevelFiles, AxesThatDescendAreTurnedRound) {
  const Axes turned{evenly(1, -0.5, 5), evenly(2, 0.5, 4), evenly(2.5, -0.5, 6)};
  const auto of_points = read(rectilinear(turned, scalars("p", crossings(turned), slope)), "p");
  EXPECT_EQ(of_points[0].origin, Vec3(-1, 2, 0));
  expect_slope(of_points[0]);
  const auto of_cells =
      read(rectilinear(turned, {}, scalars("p", crossings(middles(turned)), slope)), "p");
  EXPECT_EQ(of_cells[0].origin, Vec3(-0.75, 2.25, 0.25));
  expect_slope(of_cells[0]);
}

}  // namespace
}  // namespace pellucid::fields
