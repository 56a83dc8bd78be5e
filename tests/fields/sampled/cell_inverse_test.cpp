// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of every type that is accepted, bent, against their own map from coordinates to places.
#include "fields/sampled/cell_inverse.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vtkCellType.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <vector>

#include "core/indexed_random.h"
#include "fields/make_field.h"
#include "fields/sampled/cell_checks.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;

Vec3 corner(vtkGenericCell& cell, int i) {
  const double* all = cell.GetParametricCoords();
  return {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
}

/// A cell that lies in space as in its own coordinates, each point moved by at most `bend`, and
/// then far away.
void bend(vtkGenericCell& cell, int type, double bend, const Vec3& away = Vec3(0)) {
  cell.SetCellType(type);
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i) {
    const Box3 box{Vec3(-bend), Vec3(bend)};
    const Vec3 x = corner(cell, i) + IndexedRandom(7, std::uint64_t(i)).in_box(0, box) + away;
    cell.GetPoints()->SetPoint(i, x.x, x.y, x.z);
  }
}

/// VTK's functions of a pentagonal prism add up to 1 in six digits alone: of their sum it is a
/// mean.
Vec3 position(vtkGenericCell& cell, const Vec3& p) {
  double weights[27], whole = 0;
  cell.InterpolateFunctions(&p.x, weights);
  Vec3 sum(0);
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i) {
    double x[3];
    cell.GetPoints()->GetPoint(i, x);
    sum += weights[i] * Vec3(x[0], x[1], x[2]);
    whole += weights[i];
  }
  return sum / whole;
}

/// Coordinates within a cell: means of its corners by lot.
Vec3 within(vtkGenericCell& cell, std::uint64_t number) {
  const IndexedRandom random(3, number);
  Vec3 sum(0);
  double weight = 0;
  for (int i = 0; i < cell.GetNumberOfPoints(); ++i) {
    const double part = -std::log(1 - random.uniform(std::uint64_t(i)));
    sum += part * corner(cell, i), weight += part;
  }
  return sum / weight;
}

TEST(UnitCellInverse, FindsEveryPlaceWithinACell) {
  for (const int type : volume_cell_types())
    for (const Vec3& away : {Vec3(0), Vec3(4.5e6, -2e6, 0)}) {
      vtkNew<vtkGenericCell> cell;
      bend(*cell, type, 0.06, away);
      for (std::uint64_t i = 0; i < 200; ++i) {
        const Vec3 x = position(*cell, within(*cell, i));
        const auto place = place_in_cell(*cell, x);
        ASSERT_TRUE(place) << "type " << type << ", place " << i;
        // Rounding of x alone, 2^-53 of it, and as little of the sum of 27 weights.
        EXPECT_NEAR_VEC(position(*cell, *place), x, 1e-13 + 1e-15 * glm::length(away)) << type;
      }
    }
}

/// Two or more diagonals of bends from the middle, along the way to a corner.
TEST(UnitCellInverse, FindsNoneBeyondACell) {
  for (const int type : volume_cell_types()) {
    vtkNew<vtkGenericCell> cell;
    bend(*cell, type, 0.03);
    double middle[3];
    cell->GetParametricCenter(middle);
    const Vec3 center(middle[0], middle[1], middle[2]);
    for (int i = 0; i < 4; ++i)
      for (const double factor : {1.3, 2.0, 10.0}) {
        const Vec3 x = center + factor * (corner(*cell, i) - center);
        EXPECT_FALSE(place_in_cell(*cell, x)) << "type " << type << ", corner " << i;
      }
  }
}

/// The first face along x is an edge: on it the second coordinate means nothing.
TEST(UnitCellInverse, FindsPlacesOnACollapsedFace) {
  vtkNew<vtkGenericCell> cell;
  bend(*cell, VTK_HEXAHEDRON, 0.05);
  for (const auto& [kept, moved] : {std::pair(0, 3), {4, 7}}) {
    double x[3];
    cell->GetPoints()->GetPoint(kept, x);
    cell->GetPoints()->SetPoint(moved, x);
  }
  for (const double s : {0.0, 1e-14, 1e-9, 1e-4, 0.5})
    for (const double t : {0.0, 0.3, 1.0}) {
      const Vec3 x = position(*cell, {s, 0.4, t});
      const auto place = place_in_cell(*cell, x);
      ASSERT_TRUE(place) << s << ' ' << t;
      EXPECT_NEAR_VEC(position(*cell, *place), x, 1e-12);
    }
}

/// A thousandth of a millionth of the cell is a rounding, and more is outside.
TEST(UnitCellInverse, ForgivesARounding) {
  vtkNew<vtkGenericCell> cell;
  bend(*cell, VTK_WEDGE, 0);
  EXPECT_TRUE(place_in_cell(*cell, {0.3, 0.3, 1 + 1e-10}));
  EXPECT_TRUE(place_in_cell(*cell, {0.5 + 1e-10, 0.5 + 1e-10, 0.5}));
  EXPECT_FALSE(place_in_cell(*cell, {0.5 + 1e-6, 0.5 + 1e-6, 0.5}));
  EXPECT_FALSE(place_in_cell(*cell, {0.3, 0.3, 1 + 1e-6}));
}

/// Pyramids whose determinants are 0.05 and more at each corner, and coordinates at which the
/// search of VTK 9.1 finds no cell.
struct GivenUp {
  std::vector<Vec3> points;
  Vec3 place;
};
const GivenUp pyramids[] = {{{{0.12, 0.17, -0.23},
                              {1.09, 0.1, 0.23},
                              {1.16, 0.9, 0.02},
                              {0.14, 0.83, 0.24},
                              {0.74, 0.28, 0.35}},
                             {0.73, 0.88, 0.04}},
                            {{{0.22, 0.11, 0.2},
                              {0.97, -0.2, -0.17},
                              {1.05, 1.19, 0.1},
                              {0.03, 1.02, -0.2},
                              {0.38, 0.29, 0.31}},
                             {0.92, 0.77, 0.12}},
                            {{{0.02, -0.13, -0.21},
                              {1.07, 0.12, 0.2},
                              {1.21, 0.96, -0.09},
                              {-0.11, 1.13, -0.01},
                              {0.51, 0.32, 0.28}},
                             {0.89, 0.96, 0.23}}};

TEST(UnitCellInverse, WhatVtkGivesUpIsFound) {
  const TemporaryFolder folder;
  for (const auto& [points, place] : pyramids) {
    write_bytes(folder / "p.vtu", unstructured(points, {{VTK_PYRAMID, {0, 1, 2, 3, 4}}},
                                               vectors("U", points, straight)));
    vtkNew<vtkGenericCell> cell;
    cell->SetCellType(VTK_PYRAMID);
    for (int i = 0; i < 5; ++i) {
      const Vec3& x = points[std::size_t(i)];
      cell->GetPoints()->SetPoint(i, x.x, x.y, x.z);
    }
    const Vec3 x = position(*cell, place);
    const auto field = make_field((folder / "p.vtu").string());
    EXPECT_NEAR_VEC(velocity_of(*field, x), straight(x), 1e-12);
    expect_consistent_jacobian(*field, x, 0, 1e-5, 1e-4);
  }
}

/// A polar grid, whose innermost cells have lost a face to the axis, under a flow that linear
/// interpolation keeps.
TEST(UnitCellInverse, ThePolarAxisIsWithin) {
  const int radii = 5, turns = 13, layers = 4;
  std::vector<Vec3> points;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < turns; ++j)
      for (int i = 0; i < radii; ++i) {
        const double angle = 6.283185307179586 * j / (turns - 1), r = 0.5 * i;
        points.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.5 * k);
      }
  const TemporaryFolder folder;
  write_bytes(
      folder / "d.vts",
      vtk_files::xml(
          "StructuredGrid",
          fmt::format("<StructuredGrid WholeExtent=\"{0}\"><Piece Extent=\"{0}\">{1}"
                      "<Points>{2}</Points></Piece></StructuredGrid>",
                      fmt::format("0 {} 0 {} 0 {}", radii - 1, turns - 1, layers - 1),
                      data(vectors("U", points, straight), {}),
                      vtk_files::array("points", "Float64", 3, vtk_files::numbers(points)))));
  const auto field = make_field((folder / "d.vts").string());
  const auto sampler = field->sampler();
  for (int i = 0; i <= 60; ++i)
    for (const double off : {0.0, 1e-14, 1e-9, 1e-6, 1e-3}) {
      const Vec3 x(off, 0.5 * off, 1.5 * i / 60);
      Vec3 v;
      Mat3 jacobian;
      ASSERT_EQ(sampler->velocity_and_jacobian(x, 0, v, jacobian), SampleStatus::ok) << text_of(x);
      EXPECT_NEAR_VEC(v, straight(x), 1e-8);
      const Mat3 expected(Vec3(1, 0, 3), Vec3(0, 1, -1), Vec3(-2, 1, 0));
      EXPECT_LE(norm(jacobian - expected), 1e-5) << text_of(x);
    }
}

}  // namespace
}  // namespace pellucid::fields
