// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level_files.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "fields/levels/level_field.h"
#include "fields/levels/surface_cells.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"
#include "tests/support/levels.h"

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
    return rounded(read_levels(folder_ / "l.vtr", scalar, velocity).levels, 0).levels;
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
  write_bytes(folder_ / "v.vtr", text);
  const ScaledLevels scaled = rounded(read_levels(folder_ / "v.vtr", "magnitude", "U").levels, 1.5);
  EXPECT_NEAR(scaled.scale.value(scaled.levels[0].at(0, 0, 0)), std::sqrt(5.0),
              1e-7);  // at (-1, 2)
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

TEST_F(UnitLevelFiles, OfPointsAndCellsOfOneNameOneIsNamed) {
  write_bytes(folder_ / "both.vtr", rectilinear(cubes, scalars("p", crossings(cubes), slope),
                                                scalars("p", crossings(middles(cubes)), slope)));
  const auto size = [&](std::string_view scalar) {
    return rounded(read_levels(folder_ / "both.vtr", scalar).levels, 0).levels.front().size;
  };
  EXPECT_EQ(size("point:p"), (std::array{5, 4, 6}));
  EXPECT_EQ(size("cell:p"), (std::array{4, 3, 5}));
  EXPECT_EQ(size("p"), (std::array{5, 4, 6}));
  EXPECT_THAT(read_levels(folder_ / "both.vtr", "p").remarks,
              ::testing::ElementsAre("of both.vtr the scalar p of the points is drawn; cell:p is "
                                     "that of the cells"));
  EXPECT_TRUE(read_levels(folder_ / "both.vtr", "cell:p").remarks.empty());
  EXPECT_THAT(complaint(rectilinear(cubes, scalars("p", crossings(cubes), slope)), "cell:p"),
              HasSubstr("no array is the scalar 'cell:p'; arrays: p (point"));
}

TEST_F(UnitLevelFiles, OtherEndingsAreNamed) {
  for (const char* name : {"x.raw", "x.xdmf", "x"}) {
    write_bytes(folder_ / name, "NRRD0004");
    EXPECT_THAT(
        [&] { read_levels(folder_ / name, "p"); },
        ::testing::ThrowsMessage<InputError>(::testing::AllOf(
            HasSubstr(std::string(name) + ": ending '"),
            HasSubstr("accepted of an isosurface: .vdb, .vti"), HasSubstr(".pvd, .series"))));
  }
}

/// The slope in numbers of 16 bits, in an image whose axes run against x and y.
TEST_F(UnitLevelFiles, ScalarsOfAMetaImage) {
  std::string bytes;
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i) {
        const auto value = std::int16_t(slope({1 - 0.5 * i, 3.5 - 0.5 * j, 0.5 * k}) * 2);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
      }
  write_bytes(folder_ / "l.mha",
              "ObjectType = Image\nNDims = 3\nDimSize = 5 4 6\nElementType = MET_SHORT\n"
              "TransformMatrix = -1 0 0 0 -1 0 0 0 1\nOffset = 1 3.5 0\n"
              "ElementSpacing = 0.5 0.5 0.5\nElementDataFile = LOCAL\n" +
                  bytes);
  const auto levels = rounded(read_levels(folder_ / "l.mha", "MetaImage").levels, 0).levels;
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_EQ(levels[0].origin, Vec3(-1, 2, 0));
  EXPECT_EQ(levels[0].size, (std::array{5, 4, 6}));
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 5; ++i)
        EXPECT_EQ(levels[0].at(i, j, k), 2 * slope(levels[0].world(Vec3(i, j, k))));
  EXPECT_THAT([&] { read_levels(folder_ / "l.mha", "p"); },
              ::testing::ThrowsMessage<InputError>(
                  HasSubstr("no array is the scalar 'p'; arrays: MetaImage (point")));
}

TEST_F(UnitLevelFiles, ListsOfFilesOverTime) {
  const auto file_of = [&](double offset) {
    return rectilinear(
        cubes, scalars("p", crossings(cubes), [&](const Vec3& x) { return slope(x) + offset; }));
  };
  write_bytes(folder_ / "a.vtr", file_of(0));
  write_bytes(folder_ / "b.vtr", file_of(1000));
  // The later one first, as a list may have them.
  write_bytes(folder_ / "l.pvd",
              "<VTKFile type=\"Collection\"><Collection><DataSet timestep=\"2\" file=\"b.vtr\"/>"
              "<DataSet timestep=\"0.5\" file=\"a.vtr\"/></Collection></VTKFile>");
  write_bytes(folder_ / "l.vtr.series",
              R"({"file-series-version": "1.0", "files": [{"name": "b.vtr", "time": 2},
                                                        {"name": "a.vtr", "time": 0.5}]})");
  for (const char* name : {"l.pvd", "l.vtr.series"}) {
    const auto range = [&](const char* time) {
      return read_levels(folder_ / name, "p", {}, time).range.x;
    };
    EXPECT_EQ(range("last"), range("first") + 1000) << name;
    EXPECT_EQ(range("2"), range("last")) << name;
    EXPECT_EQ(range(""), range("0.5")) << name;
    EXPECT_THAT(
        read_levels(folder_ / name, "p").remarks,
        ::testing::ElementsAre(std::string(name) + " is drawn at 0.5, the first of its 2 times"));
    EXPECT_TRUE(read_levels(folder_ / name, "p", {}, "last").remarks.empty());
    EXPECT_THAT([&] { range("7"); }, ::testing::ThrowsMessage<InputError>(
                                         HasSubstr("one of its 2 times from 0.5 to 2")));
  }
}

/// A plane of the samples, which differ by less than a float tells apart at their size.
TEST_F(UnitLevelFiles, SmallDifferencesOfLargeNumbersAreKept) {
  for (const double unit : {1.0, 1e300, 1e-300}) {
    const auto pressure = [&](const Vec3& x) { return unit * (101325 + 0.005 * x.x); };
    write_bytes(folder_ / "p.vtr", rectilinear(cubes, scalars("p", crossings(cubes), pressure)));
    FileLevels file = read_levels(folder_ / "p.vtr", "p");
    EXPECT_EQ(file.range, Vec2(pressure(Vec3(-1)), pressure(Vec3(1))));
    const Vec3 x(0.3, 2.7, 1.1);
    const double value = pressure(x);
    ScaledLevels samples = rounded(std::move(file.levels), value);
    const LevelField field(std::move(samples.levels), find_reconstruction("trilinear"), {},
                           samples.scale);
    // Of 101325 a double tells 1.5e-11 apart, 3e-9 in x; a float 8e-3, 1.6 in x.
    const double slope_in_x = field.gradient(x)->x;
    EXPECT_NEAR(*field.height(x, value) / slope_in_x, 0, 1e-8) << unit;
    EXPECT_NEAR(*field.height(x + Vec3(0.1, 0, 0), value) / slope_in_x, 0.1, 1e-8) << unit;
    EXPECT_NEAR(*field.value(x) / unit, 101325 + 0.005 * 0.3, 1e-10) << unit;
    EXPECT_EQ(surface_cells(field, value).size(), 3u * 5u) << unit;  // of one layer across x
  }
}

TEST_F(UnitLevelFiles, DoublesThatAreFloatsStayAsTheyAre) {
  write_bytes(folder_ / "f.vtr", rectilinear(cubes, scalars("p", crossings(cubes), slope)));
  const auto levels = testing::read_float_levels(folder_ / "f.vtr", "p");
  const ScaledLevels same = rounded(ExactLevels(levels), 0.3);
  EXPECT_EQ(same.levels.front().samples, levels.front().samples);
  EXPECT_EQ(same.scale.value(0.3), 0.3);
}

/// A rotation of 0.01 within a wind of 1e5, whose Q is 1e-4 everywhere.
TEST_F(UnitLevelFiles, DerivedScalarsAreOfTheDoubles) {
  const auto wind = [](const Vec3& x) { return Vec3(1e5 - 1e-2 * x.y, 1e-2 * x.x, 0); };
  write_bytes(folder_ / "w.vtr", rectilinear(cubes, vectors("U", crossings(cubes), wind)));
  const Vec2 range = read_levels(folder_ / "w.vtr", "q").range;
  // Differences of 1e5 are right to 1.5e-11: over a step of a half, times the other of 1e-2.
  EXPECT_NEAR(range.x, 1e-4, 1e-11);
  EXPECT_NEAR(range.y, 1e-4, 1e-11);
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
