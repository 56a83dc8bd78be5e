// SPDX-License-Identifier: GPL-3.0-or-later
// Data that lie on a plane: one layer of a grid, or surface cells.

#include <gmock/gmock.h>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;

class UnitPlanar : public ::testing::Test {
 protected:
  std::unique_ptr<VectorField> read(std::string_view name, const std::string& text,
                                    std::string_view options = {}) {
    write_bytes(folder_ / name, text);
    return make_field((folder_ / name).string() + std::string(options));
  }
  std::string complaint(std::string_view name, const std::string& text,
                        std::string_view options = {}) {
    try {
      read(name, text, options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  TemporaryFolder folder_;
};

/// A grid that is flat along an axis, at 0.75.
Axes flat_along(std::size_t axis) {
  Axes axes{evenly(0, 0.5, 5), evenly(0, 0.25, 7), evenly(0, 1, 6)};
  axes[axis] = {0.75};
  return axes;
}

TEST_F(UnitPlanar, OneLayerAlongAnyAxis) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const char* options : {"", ":sampler=c1"}) {
      const Axes axes = flat_along(axis);
      const auto field =
          read("p.vtr", rectilinear(axes, vectors("U", crossings(axes), straight)), options);
      Vec3 x(0.9, 0.6, 1.2);
      x[int(axis)] = 0.75;
      Vec3 expected = straight(x);
      expected[int(axis)] = 0;
      EXPECT_NEAR_VEC(velocity_of(*field, x), expected, 1e-12) << axis << options;
      Vec3 beside = x;
      beside[int(axis)] += 1e-3;
      EXPECT_EQ(status_at(*field, beside), SampleStatus::outside);
      EXPECT_EQ(field->domain().min[int(axis)], 0.75);
      EXPECT_EQ(field->domain().max[int(axis)], 0.75);
      EXPECT_THAT(field->description(), HasSubstr("on a plane"));
    }
}

TEST_F(UnitPlanar, TheJacobianIsThatWithinThePlane) {
  const Axes axes = flat_along(2);
  const auto field = read("p.vtr", rectilinear(axes, vectors("U", crossings(axes), straight)));
  Vec3 v;
  Mat3 jacobian;
  ASSERT_EQ(field->sampler()->velocity_and_jacobian({0.9, 0.6, 0.75}, 0, v, jacobian),
            SampleStatus::ok);
  EXPECT_LE(norm(jacobian - Mat3(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0))), 1e-12);
}

TEST_F(UnitPlanar, TwoComponentsBelongToTheTwoAxes) {
  const Axes axes = flat_along(1);
  const auto points = crossings(axes);
  std::string text;
  for (const Vec3& x : points) text += fmt::format("{} {} ", straight(x).x, straight(x).z);
  const auto field = read("p.vtr", rectilinear(axes, vtk_files::array("U", "Float64", 2, text)));
  const Vec3 x(0.9, 0.75, 1.2);
  EXPECT_NEAR_VEC(velocity_of(*field, x), Vec3(straight(x).x, 0, straight(x).z), 1e-12);
  const std::string two = scalars("u", points, [](const Vec3& p) { return straight(p).x; }) +
                          scalars("w", points, [](const Vec3& p) { return straight(p).z; });
  EXPECT_NEAR_VEC(velocity_of(*read("p.vtr", rectilinear(axes, two), ":array=u,w"), x),
                  Vec3(straight(x).x, 0, straight(x).z), 1e-12);
}

TEST_F(UnitPlanar, TwoComponentsOfAVolumeAreRefused) {
  const Axes axes{evenly(0, 1, 3), evenly(0, 1, 3), evenly(0, 1, 3)};
  std::string text;
  for (int i = 0; i < 27; ++i) text += "1 0 ";
  EXPECT_THAT(complaint("v.vtr", rectilinear(axes, vtk_files::array("U", "Float64", 2, text))),
              HasSubstr("arrays: U (point, 2 components, lengths 1 … 1)"));
}

TEST_F(UnitPlanar, ConstantCellsOfOneLayer) {
  const Axes axes = flat_along(2);
  const auto field =
      read("p.vtr", rectilinear(axes, {}, vectors("U", crossings(middles(axes)), straight)),
           ":cells=constant");
  EXPECT_NEAR_VEC(velocity_of(*field, {0.9, 0.6, 0.75}),
                  Vec3(straight({0.75, 0.625, 0.75})) * Vec3(1, 1, 0), 1e-12);
}

TEST_F(UnitPlanar, ALineIsNoField) {
  const Axes axes{evenly(0, 1, 3), {0}, {0}};
  const std::string velocity = vectors("U", crossings(axes), straight);
  EXPECT_THAT(complaint("l.vtr", rectilinear(axes, velocity)), HasSubstr("fewer than two axes"));
  EXPECT_THAT(complaint("l.vts", structured(axes, velocity)), HasSubstr("two axes"));
}

// A slanted plane: e1, e2 span it.
const Vec3 e1 = glm::normalize(Vec3(1, 0, 1)), e2(0, 1, 0), normal = glm::normalize(Vec3(-1, 0, 1));
Vec3 on_slope(double a, double b) { return Vec3(0.5, -2, 3) + a * e1 + b * e2; }

/// Triangles, quadrilaterals, a polygon and a quadratic triangle beside each other.
std::string slanted(bool bent) {
  std::vector<Vec3> points{on_slope(0, 0), on_slope(1, 0),   on_slope(1, 1),     on_slope(0, 1),
                           on_slope(2, 0), on_slope(2, 1),   on_slope(3, 0),     on_slope(3, 1),
                           on_slope(4, 0), on_slope(4, 1),   on_slope(4.5, 0.5), on_slope(3, 3),
                           on_slope(3, 2), on_slope(2.5, 2), on_slope(2.5, 1)};
  if (bent) points[10] += 0.1 * normal;
  return unstructured(points,
                      {{5, {0, 1, 2}},
                       {5, {0, 2, 3}},
                       {9, {1, 4, 5, 2}},
                       {8, {4, 6, 5, 7}},
                       {7, {6, 8, 10, 9, 7}},
                       {22, {5, 7, 11, 14, 12, 13}}},
                      vectors("U", points, straight));
}

TEST_F(UnitPlanar, SurfaceCellsOfAnySlant) {
  const auto field = read("s.vtu", slanted(false));
  for (const Vec3& x :
       {on_slope(0.7, 0.2), on_slope(0.2, 0.7), on_slope(1.3, 0.4), on_slope(2.6, 0.7),
        on_slope(4.2, 0.5), on_slope(3.5, 0.9), on_slope(2.7, 1.5)}) {
    const Vec3 v = straight(x);
    EXPECT_NEAR_VEC(velocity_of(*field, x), v - glm::dot(v, normal) * normal, 1e-9);
    EXPECT_EQ(status_at(*field, x + 1e-3 * normal), SampleStatus::outside);
  }
  EXPECT_EQ(status_at(*field, on_slope(0.5, 1.5)), SampleStatus::outside);
  EXPECT_NEAR(field->domain().max.y, 1, 1e-15);
}

TEST_F(UnitPlanar, SurfacesThatAreNoPlaneAreRefused) {
  EXPECT_THAT(complaint("s.vtu", slanted(true)), HasSubstr("its surface is no plane: point "));
  const std::vector<Vec3> two{{0, 0, 0}, {1, 0, 0}};
  EXPECT_THAT(complaint("l.vtu", unstructured(two, {{3, {0, 1}}}, vectors("U", two, straight))),
              HasSubstr("nor surface cells"));
}

/// A square with a square hole, whose outline goes in along a bridge and out again: VTK divides it
/// into nothing. Without an area a polygon is none, and is passed over.
TEST_F(UnitPlanar, PolygonsWithHolesAreRefused) {
  const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0},  {1, 1, 0},
                                 {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {-2, 0, 0}, {-2, 4, 0}};
  const Cell hole{7, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}};
  const Cell square{9, {8, 0, 3, 9}}, line{7, {8, 0, 1, 8}};
  const std::string velocity = vectors("U", points, straight);
  EXPECT_THAT(complaint("h.vtu", unstructured(points, {square, hole}, velocity)),
              HasSubstr("cell 1: its 10 corners"));
  EXPECT_EQ(complaint("l.vtu", unstructured(points, {square, line}, velocity)), "no complaint");
}

TEST_F(UnitPlanar, StructuredLayersAreSurfaces) {
  const Axes axes = flat_along(1);
  const auto field = read("p.vts", structured(axes, vectors("U", crossings(axes), straight)));
  const Vec3 x(0.9, 0.75, 1.2), v = straight(x);
  EXPECT_NEAR_VEC(velocity_of(*field, x), Vec3(v.x, 0, v.z), 1e-9);
}

}  // namespace
}  // namespace pellucid::fields
