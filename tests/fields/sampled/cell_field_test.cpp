// SPDX-License-Identifier: GPL-3.0-or-later
// Kinds of cells that the common grid of the other tests does not hold.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <vector>

#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {
namespace {

/// A file with one cell of a VTK type.
std::unique_ptr<VectorField> one_cell(const TemporaryFolder& folder, int type,
                                      const std::vector<Vec3>& points, const Velocity& velocity) {
  std::string positions, vectors, corners;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 v = velocity(points[i]);
    positions += fmt::format("{} {} {}\n", points[i].x, points[i].y, points[i].z);
    vectors += fmt::format("{} {} {}\n", v.x, v.y, v.z);
    corners += fmt::format(" {}", i);
  }
  const std::size_t count = points.size();
  write_bytes(folder / "cell.vtk",
              fmt::format("# vtk DataFile Version 3.0\none cell\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                          "POINTS {0} double\n{1}CELLS 1 {2}\n{0}{3}\nCELL_TYPES 1\n{4}\n"
                          "POINT_DATA {0}\nVECTORS v double\n{5}",
                          count, positions, count + 1, corners, type, vectors));
  return make_field((folder / "cell.vtk").string());
}

void expect_velocity(const VectorField& field, const Velocity& velocity,
                     const std::vector<Vec3>& places) {
  for (const Vec3& x : places) {
    EXPECT_NEAR_VEC(velocity_of(field, x), velocity(x), 1e-9);  // Newton's iterations
    expect_consistent_jacobian(field, x, 0, 1e-5, 1e-4);        // 1e-9 over the step
  }
}

const Velocity sheared = [](const Vec3& x) {
  return Vec3(1 + x.x - 2 * x.z, x.y + x.z, 3 * x.x - x.y);
};
const Velocity parabola = [](const Vec3& x) {
  return Vec3(x.x * x.x - x.y, x.y * x.z, x.z * x.z + x.x * x.y);
};

TEST(UnitCells, Pyramid) {
  const TemporaryFolder folder;
  const auto field =
      one_cell(folder, 14, {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1.5}}, sheared);
  expect_velocity(*field, sheared, {{1, 1, 0.2}, {0.7, 1.2, 0.5}, {1, 1, 1.2}});
  EXPECT_EQ(status_at(*field, {0.1, 0.1, 1}), SampleStatus::outside);
}

TEST(UnitCells, Voxel) {
  const TemporaryFolder folder;
  const auto field = one_cell(
      folder, 11,
      {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1, 0}, {0, 0, 3}, {2, 0, 3}, {0, 1, 3}, {2, 1, 3}},
      sheared);
  expect_velocity(*field, sheared, {{0.3, 0.4, 0.5}, {1.9, 0.9, 2.9}});
  EXPECT_EQ(status_at(*field, {2.1, 0.5, 1}), SampleStatus::outside);
}

TEST(UnitCells, QuadraticTetrahedraReproduceParabolas) {
  const TemporaryFolder folder;
  const std::vector<Vec3> corner = {{0, 0, 0}, {2, 0, 0}, {0.5, 2, 0}, {0.5, 0.5, 2}};
  std::vector<Vec3> points = corner;
  const int edges[6][2] = {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}};
  for (const auto& edge : edges) points.push_back(0.5 * (corner[edge[0]] + corner[edge[1]]));
  const auto field = one_cell(folder, 24, points, parabola);
  expect_velocity(*field, parabola, {{0.6, 0.5, 0.3}, {0.9, 0.3, 0.2}, {0.6, 0.6, 1.2}});
  EXPECT_EQ(status_at(*field, {1.5, 1.5, 1}), SampleStatus::outside);
}

TEST(UnitCells, HexagonalPrism) {
  const TemporaryFolder folder;
  std::vector<Vec3> points;
  for (const double z : {0.0, 1.0})
    for (int i = 0; i < 6; ++i)
      points.emplace_back(std::cos(1.0471975511965976 * i), std::sin(1.0471975511965976 * i), z);
  const auto field = one_cell(folder, 16, points, sheared);
  EXPECT_NEAR_VEC(velocity_of(*field, {0, 0, 0.5}), sheared({0, 0, 0.5}), 1e-6);
}

/// Four unit cubes in a row along x, the third of which is marked, under uniform flow.
std::string marked_row(const std::string& kind, int mark) {
  std::string text = "# vtk DataFile Version 3.0\nrow\nASCII\n" + kind;
  text += fmt::format("CELL_DATA 4\nFIELD f 1\nvtkGhostType 1 4 unsigned_char\n0 0 {} 0\n", mark);
  text += "POINT_DATA 20\nVECTORS v double\n";
  for (int i = 0; i < 20; ++i) text += "1 0 0\n";
  return text;
}

std::string row_of_points() {
  std::string text = "POINTS 20 double\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{} {} {}\n", i % 5, i / 5 % 2, i / 10);
  return text;
}

TEST(UnitCells, HiddenOnesAreOutsideInEveryKindOfGrid) {
  std::string cells = "CELLS 4 36\n";
  for (int i = 0; i < 4; ++i)
    cells += fmt::format("8 {} {} {} {} {} {} {} {}\n", i, i + 1, i + 6, i + 5, i + 10, i + 11,
                         i + 16, i + 15);
  const std::string kinds[] = {
      "DATASET STRUCTURED_POINTS\nDIMENSIONS 5 2 2\nORIGIN 0 0 0\nSPACING 1 1 1\n",
      "DATASET RECTILINEAR_GRID\nDIMENSIONS 5 2 2\nX_COORDINATES 5 double\n0 1 2 3 4\n"
      "Y_COORDINATES 2 double\n0 1\nZ_COORDINATES 2 double\n0 1\n",
      "DATASET STRUCTURED_GRID\nDIMENSIONS 5 2 2\n" + row_of_points(),
      "DATASET UNSTRUCTURED_GRID\n" + row_of_points() + cells + "CELL_TYPES 4\n12 12 12 12\n"};
  const TemporaryFolder folder;
  for (const std::string& kind : kinds)
    for (const int mark : {0, 1, 32}) {  // none, DUPLICATECELL, HIDDENCELL
      write_bytes(folder / "row.vtk", marked_row(kind, mark));
      const auto field = make_field((folder / "row.vtk").string());
      for (const double x : {0.5, 1.5, 2.5, 3.5}) {
        const bool inside = mark == 0 || x != 2.5;
        EXPECT_EQ(status_at(*field, {x, 0.5, 0.5}),
                  inside ? SampleStatus::ok : SampleStatus::outside)
            << kind.substr(0, 30) << " mark " << mark << " at " << x;
      }
    }
}

/// Two unit cubes, the second half within the first, which flows the other way.
std::unique_ptr<VectorField> overlapping(const TemporaryFolder& folder) {
  std::string points, cells, vectors;
  for (int i = 0; i < 16; ++i) {
    points += fmt::format("{} {} {}\n", i % 2 + 0.5 * (i / 8), i / 2 % 2, i / 4 % 2);
    vectors += i < 8 ? "1 0 0\n" : "-1 0 0\n";
  }
  for (int i = 0; i < 16; i += 8)
    cells += fmt::format("8 {} {} {} {} {} {} {} {}\n", i, i + 1, i + 3, i + 2, i + 4, i + 5, i + 7,
                         i + 6);
  write_bytes(folder / "two.vtk",
              "# vtk DataFile Version 3.0\ntwo\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 16 "
              "double\n" +
                  points + "CELLS 2 18\n" + cells +
                  "CELL_TYPES 2\n12 12\nPOINT_DATA 16\nVECTORS v double\n" + vectors);
  return make_field((folder / "two.vtk").string());
}

/// Whatever was asked before, the first cell counts; for a particle its own last one does.
TEST(UnitCells, WhereCellsOverlapTheFirstCountsOrTheParticlesLast) {
  const TemporaryFolder folder;
  const auto field = overlapping(folder);
  const Vec3 in_first(0.25, 0.5, 0.5), in_both(0.75, 0.5, 0.5), in_second(1.25, 0.5, 0.5);
  const auto sampler = field->sampler();
  const auto velocity_at = [&](const Vec3& x) {
    Vec3 v(0);
    EXPECT_EQ(sampler->velocity(x, 0, v), SampleStatus::ok);
    return v.x;
  };
  EXPECT_EQ(velocity_at(in_second), -1);
  EXPECT_EQ(velocity_at(in_both), 1);
  LastCell one, other;
  sampler->follow(&one);
  EXPECT_EQ(velocity_at(in_second), -1);
  EXPECT_EQ(velocity_at(in_both), -1);
  sampler->follow(&other);
  EXPECT_EQ(velocity_at(in_both), 1);
  sampler->follow(&one);
  EXPECT_EQ(velocity_at(in_both), -1);
  EXPECT_EQ(velocity_at(in_first), 1);
  EXPECT_EQ(velocity_at(in_both), 1);
  sampler->follow(nullptr);
  EXPECT_EQ(velocity_at(in_second), -1);
  EXPECT_EQ(velocity_at(in_both), 1);
  LastCell of_another_field{7};
  sampler->follow(&of_another_field);
  EXPECT_EQ(velocity_at(in_second), -1);
}

}  // namespace
}  // namespace pellucid::fields
