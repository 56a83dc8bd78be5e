// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars of a field's files: linear ones are kept by every interpolation.
#include "fields/readers/attributes.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::AllOf;
using ::testing::HasSubstr;

double pressure(const Vec3& x) { return 1 + 2 * x.x - 3 * x.y + 5 * x.z; }

std::string arrays(const std::vector<Vec3>& places) {
  return vectors("U", places, straight) + scalars("p", places, pressure);
}

class UnitAttributes : public ::testing::Test {
 protected:
  std::string written(std::string_view name, const std::string& text) {
    write_bytes(folder_ / name, text);
    return (folder_ / name).string();
  }
  static double value(const std::string& field, const std::string& name, const Vec3& place,
                      double time = 0) {
    return Attributes(field, {}, std::vector{name})
        .values(0, std::vector{place}, std::vector{time})
        .front();
  }
  static std::string complaint(const std::string& field, const std::string& name) {
    try {
      Attributes(field, {}, std::vector{name});
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  TemporaryFolder folder_;
};

const Axes box{evenly(0, 0.5, 4), {0, 0.25, 1, 1.5}, evenly(-1, 1, 3)};
const Vec3 inside(1.1, 0.7, 0.3);

TEST_F(UnitAttributes, AreInterpolatedAsTheVelocityIs) {
  const auto places = crossings(box);
  for (const std::string& field :
       {written("a.vtr", rectilinear(box, arrays(places))),
        written("a.vts", structured(box, arrays(places))),
        written("a.vtu", unstructured(places, hexahedra(box), arrays(places)))}) {
    EXPECT_NEAR(value(field, "p", inside), pressure(inside), 1e-12) << field;
    EXPECT_TRUE(std::isnan(value(field, "p", {5, 0, 0}))) << field;
  }
  // Four samples along each axis: Hermite's cubic keeps what is linear too.
  const Axes even{evenly(0, 0.5, 4), evenly(0, 0.5, 4), evenly(-1, 0.5, 5)};
  const std::string c1 = written("c.vtr", rectilinear(even, arrays(crossings(even))));
  EXPECT_NEAR(value(c1 + ":sampler=c1", "p", inside), pressure(inside), 1e-12);
}

TEST_F(UnitAttributes, OfCellsAreAveragedOrConstant) {
  const auto corners = crossings(box), cells = crossings(middles(box));
  const std::string field = written(
      "a.vtr", rectilinear(box, vectors("U", corners, straight), scalars("p", cells, pressure)));
  const Vec3 middle = cells[4];
  EXPECT_NEAR(value(field + ":cells=constant", "p", middle + Vec3(0.1, 0.2, 0.1)), pressure(middle),
              1e-12);
  EXPECT_FALSE(std::isnan(value(field, "p", middle)));
}

/// A velocity loses its part across the plane there; a pressure has none.
TEST_F(UnitAttributes, OfFlatDataAreWhole) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Axes axes = box;
    axes[axis] = {0.25};
    Vec3 x = inside;
    x[int(axis)] = 0.25;
    for (const std::string& field :
         {written("flat.vtr", rectilinear(axes, arrays(crossings(axes)))),
          written("flat.vts", structured(axes, arrays(crossings(axes))))})
      EXPECT_NEAR(value(field, "p", x), pressure(x), 1e-9) << field << axis;
  }
  const std::vector<Vec3> slanted{{0, 0, 0}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}};
  const std::string field =
      written("s.vtu", unstructured(slanted, {{9, {0, 1, 2, 3}}}, arrays(slanted)));
  const Vec3 x(0.4, 0.3, 0.7);
  EXPECT_NEAR(value(field, "p", x), pressure(x), 1e-9);
}

TEST_F(UnitAttributes, OfASeriesAreLinearInTime) {
  const auto places = crossings(box);
  for (const double t : {0., 2.})
    written(fmt::format("{}.vtr", t), rectilinear(box, vectors("U", places, straight) +
                                                           scalars("p", places, [&](const Vec3& x) {
                                                             return pressure(x) * (1 + t);
                                                           })));
  const std::string series = written(
      "p.series", R"({"files": [{"name": "0.vtr", "time": 0}, {"name": "2.vtr", "time": 2}]})");
  EXPECT_NEAR(value(series, "p", inside, 0.5), 1.5 * pressure(inside), 1e-12);
  EXPECT_NEAR(value(series + ":time=last", "p", inside), 3 * pressure(inside), 1e-12);
  EXPECT_TRUE(std::isnan(value(series, "p", inside, 2.5)));
}

/// Their own samples may be alike at both ends, or all the same.
TEST_F(UnitAttributes, HaveTheVelocitysPeriod) {
  const Axes ring{evenly(1, 0.25, 16), evenly(0, 1, 4), evenly(0, 1, 4)};
  const auto places = crossings(ring);
  const std::string field =
      written("ring.vtr",
              rectilinear(
                  ring, vectors("U", places,
                                [](const Vec3& x) {
                                  return Vec3(1 + 0.5 * std::sin(M_PI / 2 * x.x), 0, 0);
                                }) +
                            scalars("p", places, [](const Vec3& x) { return x.x == 2 ? 1. : 0.; }) +
                            scalars("q", places, [](const Vec3& x) { return x.y; }))) +
      ":array=U,periodic=x";
  EXPECT_NEAR(value(field, "p", {6, 1, 1}), 1, 1e-12);
  EXPECT_NEAR(value(field, "q", {6, 1, 1}), 1, 1e-12);
}

TEST_F(UnitAttributes, ArraysOfOneNameAreToldApart) {
  const auto corners = crossings(box), cells = crossings(middles(box));
  const std::string field = written(
      "a.vtr",
      rectilinear(box, arrays(corners), scalars("p", cells, [](const Vec3&) { return 7.; })));
  EXPECT_NEAR(value(field, "p", inside), pressure(inside), 1e-12);
  EXPECT_NEAR(value(field, "point:p", inside), pressure(inside), 1e-12);
  EXPECT_NEAR(value(field, "cell:p", inside), 7, 1e-12);
}

TEST_F(UnitAttributes, WhatIsNoScalarIsRefused) {
  const std::string field = written("a.vtr", rectilinear(box, arrays(crossings(box))));
  EXPECT_THAT(complaint(field, "q"), AllOf(HasSubstr("no scalar 'q'"), HasSubstr("p (point")));
  EXPECT_THAT(complaint(field, "U"), HasSubstr("no scalar 'U'"));
  EXPECT_THAT(complaint("abc", "p"), HasSubstr("abc: it has no scalar 'p'"));
}

}  // namespace
}  // namespace pellucid::fields
