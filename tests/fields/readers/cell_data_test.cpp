// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors that a file has at its cells.

#include <gmock/gmock.h>

#include <random>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;
using ::testing::Not;

const Axes axes{evenly(0, 0.5, 6), evenly(-1, 0.25, 7), evenly(2, 1, 5)};
const std::vector<Vec3> centres = crossings(middles(axes));

class UnitCellData : public ::testing::Test {
 protected:
  std::unique_ptr<VectorField> read(std::string_view name, const std::string& text,
                                    std::string_view options = {}) {
    write_bytes(folder_ / name, text);
    return make_field((folder_ / name).string() + std::string(options));
  }
  /// The same cells in the three kinds of grid.
  std::vector<std::unique_ptr<VectorField>> all_kinds(std::string_view options,
                                                      std::string_view more_cell_data = {}) {
    const std::string cells = vectors("U", centres, straight) + std::string(more_cell_data);
    std::vector<std::unique_ptr<VectorField>> fields;
    fields.push_back(read("c.vtr", rectilinear(axes, {}, cells), options));
    fields.push_back(read("c.vts", structured(axes, {}, cells), options));
    fields.push_back(
        read("c.vtu", unstructured(crossings(axes), hexahedra(axes), {}, cells), options));
    return fields;
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

TEST_F(UnitCellData, TheMeanAtInnerPointsIsExactForAStraightField) {
  for (const auto& field : all_kinds("")) {
    EXPECT_THAT(field->description(), HasSubstr("U of the cells, averaged to points"));
    // Between inner points, a cell away from the border.
    for (const Vec3& x : {Vec3(0.5, -0.75, 3), Vec3(1.3, 0.1, 3.7), Vec3(2, 0.25, 5)})
      EXPECT_NEAR_VEC(velocity_of(*field, x), straight(x), 1e-9);  // the cells' search iterates
  }
}

TEST_F(UnitCellData, TheMeanAtTheBorderIsThatOfTheCellsInside) {
  for (const auto& field : all_kinds("")) {
    EXPECT_NEAR_VEC(velocity_of(*field, {0, 0, 4}), straight({0.25, 0, 4}), 1e-9);
    EXPECT_NEAR_VEC(velocity_of(*field, {2.5, 0.5, 6}), straight({2.25, 0.375, 5.5}), 1e-9);
  }
}

TEST_F(UnitCellData, ConstantCellsHaveOneVectorEach) {
  for (const auto& field : all_kinds(":cells=constant")) {
    EXPECT_THAT(field->description(), HasSubstr("U, constant in cells"));
    EXPECT_THAT(field->description(), Not(HasSubstr("cells, constant in cells")));
    const auto sampler = field->sampler();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> off(-0.49, 0.49);
    for (const Vec3& centre : centres) {
      const Vec3 x = centre + Vec3(0.5 * off(random), 0.25 * off(random), off(random));
      Vec3 v;
      Mat3 jacobian;
      ASSERT_EQ(sampler->velocity_and_jacobian(x, 0, v, jacobian), SampleStatus::ok);
      EXPECT_NEAR_VEC(v, straight(centre), 1e-14);
      EXPECT_EQ(norm(jacobian), 0);
    }
  }
}

TEST_F(UnitCellData, TheErrorOfConstantCellsIsThatAtTheirCorners) {
  // Half a cell along each axis: (0.25, 0.125, 0.5) and all signs of it.
  double expected = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 half((corner & 1 ? 1 : -1) * 0.25, (corner & 2 ? 1 : -1) * 0.125,
                    (corner & 4 ? 1 : -1) * 0.5);
    expected = std::max(expected, glm::length(straight(half) - straight(Vec3(0))));
  }
  const auto fields = all_kinds(":cells=constant");
  EXPECT_NEAR(*fields[1]->sampling_error(), expected, 1e-12);
  EXPECT_NEAR(*fields[2]->sampling_error(), expected, 1e-12);
  // Along axes the three parts are added as if they had one direction.
  EXPECT_GE(*fields[0]->sampling_error(), expected);
  EXPECT_LE(*fields[0]->sampling_error(), 2 * expected);
}

TEST_F(UnitCellData, HiddenCellsDoNotCount) {
  // The cells of the first layer along x are hidden, and hold nonsense.
  const auto hidden = [](const Vec3& x) { return x.x < 0.5 ? 32.0 : 0.0; };
  const std::string cells =
      vectors("U", centres, [](const Vec3& x) { return x.x < 0.5 ? Vec3(1e30) : straight(x); }) +
      scalars("vtkGhostType", centres, hidden, "UInt8");
  const auto field = read("h.vtr", rectilinear(axes, {}, cells));
  EXPECT_NEAR_VEC(velocity_of(*field, {0.5, 0, 4}), straight({0.75, 0, 4}), 1e-9);
  EXPECT_EQ(status_at(*field, {0.3, 0, 4}), SampleStatus::outside);
  const auto constant = read("h.vtr", rectilinear(axes, {}, cells), ":cells=constant");
  EXPECT_NEAR_VEC(velocity_of(*constant, {0.6, 0.1, 4.1}), straight({0.75, 0.125, 4.5}), 1e-14);
}

TEST_F(UnitCellData, FacesOfTheBorderSayNothingOfTheVolume) {
  auto cells = hexahedra(axes);
  cells.push_back({9, {0, 1, 7, 6}});
  auto places = centres;
  places.emplace_back(99);  // the quadrilateral's
  const auto field = read(
      "b.vtu", unstructured(crossings(axes), cells, {}, vectors("U", places, [](const Vec3& x) {
                              return x.x == 99 ? Vec3(1e30) : straight(x);
                            })));
  EXPECT_NEAR_VEC(velocity_of(*field, {0, -1, 2}), straight({0.25, -0.875, 2.5}), 1e-9);
}

TEST_F(UnitCellData, PointsComeBeforeCellsUnlessTheyAreNamed) {
  const std::string text =
      rectilinear(axes, vectors("U", crossings(axes), [](const Vec3&) { return Vec3(1, 0, 0); }),
                  vectors("U", centres, [](const Vec3&) { return Vec3(2, 0, 0); }));
  EXPECT_EQ(velocity_of(*read("u.vtr", text), {1, 0, 3}).x, 1);
  EXPECT_EQ(velocity_of(*read("u.vtr", text, ":array=U"), {1, 0, 3}).x, 1);
  EXPECT_EQ(velocity_of(*read("u.vtr", text, ":array=cell:U"), {1, 0, 3}).x, 2);
  EXPECT_EQ(velocity_of(*read("u.vtr", text, ":array=point:U"), {1, 0, 3}).x, 1);
  EXPECT_EQ(velocity_of(*read("u.vtr", text, ":cells=constant"), {1, 0, 3}).x, 2);
}

/// `text` with an array that is called its points' or its cells' `role`.
std::string with_role(std::string text, const std::string& element, const std::string& role,
                      const std::string& name) {
  const std::string tag = "<" + element + ">";
  return text.replace(text.find(tag), tag.size(),
                      fmt::format("<{} {}=\"{}\">", element, role, name));
}

const VectorAt along_x = [](const Vec3&) { return Vec3(1, 0, 0); };
const VectorAt along_y = [](const Vec3&) { return Vec3(0, 1, 0); };

TEST_F(UnitCellData, WhatAFileCallsItsVectorsComesFirst) {
  const std::string text =
      rectilinear(axes, vectors("V", crossings(axes), along_y), vectors("U", centres, along_x));
  const Vec3 x(1, 0, 3);
  EXPECT_EQ(velocity_of(*read("u.vtr", with_role(text, "CellData", "Vectors", "U")), x).x, 1);
  EXPECT_EQ(velocity_of(*read("u.vtr", with_role(text, "PointData", "Vectors", "V")), x).y, 1);
  EXPECT_THAT(
      complaint("u.vtr", text),
      ::testing::AllOf(HasSubstr("which vectors?"), HasSubstr("V (point"), HasSubstr("U (cell")));
}

TEST_F(UnitCellData, ColoursNormalsAndTexturesAreNoVelocity) {
  const auto points = crossings(axes);
  std::string bytes;
  for (std::size_t i = 0; i < points.size(); ++i) bytes += "200 100 0 ";
  const std::string cells = vectors("U", centres, along_x);
  const Vec3 x(1, 0, 3);
  struct Other {
    std::string array, role, name;
  };
  for (const auto& [array, role, name] :
       {Other{vtk_files::array("paint", "UInt8", 3, bytes), "Scalars", "paint"},
        Other{vectors("n", points, along_y), "Normals", "n"},
        Other{vectors("t", points, along_y), "TCoords", "t"},
        Other{vectors("Normals", points, along_y), "Scalars", ""}}) {
    SCOPED_TRACE(name);
    const auto with = [&](const std::string& text) {
      return name.empty() ? text : with_role(text, "PointData", role, name);
    };
    EXPECT_EQ(velocity_of(*read("o.vtr", with(rectilinear(axes, array, cells))), x).x, 1);
    EXPECT_THAT(complaint("o.vtr", with(rectilinear(axes, array))), HasSubstr("which vectors?"));
    if (name == "n") {
      EXPECT_EQ(velocity_of(*read("o.vtr", with(rectilinear(axes, array)), ":array=n"), x).y, 1);
    }
  }
}

TEST_F(UnitCellData, ThreeScalarsAreVectors) {
  const auto points = crossings(axes);
  const auto component = [](int axis) {
    return [axis](const Vec3& x) { return straight(x)[axis]; };
  };
  const std::string three = scalars("u", points, component(0)) +
                            scalars("v", points, component(1)) + scalars("w", points, component(2));
  const Vec3 x(1.3, 0.1, 3.7), v = straight(x);
  EXPECT_NEAR_VEC(velocity_of(*read("s.vtr", rectilinear(axes, three), ":array=u,v,w"), x), v,
                  1e-12);
  EXPECT_NEAR_VEC(
      velocity_of(*read("s.vtr", rectilinear(axes, three), ":array=w,v,u,sampler=c1"), x),
      Vec3(v.z, v.y, v.x), 1e-12);
  for (const char* options : {":array=u,u,u", ":array=u,u,u,sampler=c1"})
    EXPECT_NEAR_VEC(velocity_of(*read("s.vtr", rectilinear(axes, three), options), x), Vec3(v.x),
                    1e-12);
  EXPECT_NEAR_VEC(velocity_of(*read("s.vtr", rectilinear(axes, three), ":array=u,v,u"), x),
                  Vec3(v.x, v.y, v.x), 1e-12);
  EXPECT_NEAR_VEC(velocity_of(*read("s.vtr", rectilinear(axes, three), ":array=u,v,0"), x),
                  Vec3(v.x, v.y, 0), 1e-12);
  EXPECT_NEAR_VEC(
      velocity_of(*read("s.vtr", rectilinear(axes, three), ":array=0,0,w,sampler=c1"), x),
      Vec3(0, 0, v.z), 1e-12);
  EXPECT_THAT(complaint("s.vtr", rectilinear(axes, three), ":array=0,0,0"),
              HasSubstr("array=0,0,0: no such vectors"));
  EXPECT_THAT(
      complaint("s.vtr", rectilinear(axes, three)),
      HasSubstr(
          "which vectors? accepted: array=NAME, array=U,V,W or array=U,V,0, of three components "
          "together; arrays: u (point, 1 component, -11 … -0.5)"));
  EXPECT_THAT(complaint("s.vtr", rectilinear(axes, three), ":array=u,v,q"),
              HasSubstr("array=u,v,q: no such vectors"));
  EXPECT_THAT(complaint("s.vtr", rectilinear(axes, three), ":array=u,v"),
              HasSubstr("array=u,v: no such vectors"));
}

TEST_F(UnitCellData, ArraysAreListedWithKindComponentsAndRange) {
  const std::string text =
      rectilinear(axes, scalars("p", crossings(axes), [](const Vec3& x) { return x.x; }),
                  vectors("U", centres, [](const Vec3& x) { return Vec3(0, 3, x.x > 1 ? 4 : 0); }) +
                      vectors("V", centres, straight));
  EXPECT_THAT(complaint("l.vtr", text),
              HasSubstr("arrays: p (point, 1 component, 0 … 2.5), U (cell, 3 components, lengths "
                        "3 … 5), V (cell, 3 components, lengths"));
  EXPECT_THAT(complaint("l.vtr", text), Not(HasSubstr("\n")));
}

TEST_F(UnitCellData, NamesMayHaveCommas) {
  const std::string text = rectilinear(
      axes, vectors("U", crossings(axes), [](const Vec3&) { return Vec3(1, 0, 0); }) +
                vectors("U,mean", crossings(axes), [](const Vec3&) { return Vec3(2, 0, 0); }));
  EXPECT_EQ(velocity_of(*read("n.vtr", text, ":array=U,mean"), {1, 0, 3}).x, 2);
  EXPECT_EQ(velocity_of(*read("n.vtr", text, ":array=U,mean,sampler=c1"), {1, 0, 3}).x, 2);
  EXPECT_THAT(complaint("n.vtr", text, ":array=U,arrey=V"), HasSubstr("arrey"));
  EXPECT_THAT(complaint("n.vtr", text, ":array=U,array=V"), HasSubstr("given twice"));
  EXPECT_THAT(complaint("n.vtr", text, ":U"), HasSubstr("key=value"));
}

TEST_F(UnitCellData, ConstantCellsHaveNoSlope) {
  EXPECT_THAT(complaint("c.vtr", rectilinear(axes, {}, vectors("U", centres, straight)),
                        ":cells=constant,sampler=c1"),
              HasSubstr("accepted: cells=averaged"));
  EXPECT_THAT(complaint("c.vtr", rectilinear(axes, vectors("U", crossings(axes), straight)),
                        ":cells=constant"),
              HasSubstr("of the cells; arrays: U (point"));
}

}  // namespace
}  // namespace pellucid::fields
