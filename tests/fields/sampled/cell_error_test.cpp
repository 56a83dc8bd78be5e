// SPDX-License-Identifier: GPL-3.0-or-later
// The sampling error of cells, and what a lot of the nodes makes of it.
#include "fields/sampled/cell_error.h"

#include <gtest/gtest.h>
#include <vtkDataSet.h>

#include "readers/vtk/vtk_file.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;

class UnitCellError : public ::testing::Test {
 protected:
  /// Unit cubes, as hexahedra of a grid without axes.
  CellGrid cubes(int count, const VectorAt& velocity, CellValues values = CellValues::averaged) {
    const auto positions = evenly(0, 1, count + 1);
    const Axes axes{positions, positions, positions};
    const auto places = values == CellValues::constant ? crossings(middles(axes)) : crossings(axes);
    const std::string array = vectors("U", places, velocity);
    const std::string points = values == CellValues::constant ? "" : array;
    const std::string cells = values == CellValues::constant ? array : "";
    write_bytes(path_, unstructured(crossings(axes), hexahedra(axes), points, cells));
    const auto data = readers::read_vtk_data_set(path_);
    return make_cell_grid(data, pick_vectors(*data, "U", values, path_), path_);
  }
  TemporaryFolder folder_;
  std::filesystem::path path_ = folder_ / "c.vtu";
};

const VectorAt bowl = [](const Vec3& x) { return Vec3(x.x * x.x, 0, 0); };

/// h²/8 |f''| = 1/4, at inner nodes and at all of them where a lot has to find some of many.
TEST_F(UnitCellError, OfAParabolaIsThatOfStraightLines) {
  const CellGrid grid = cubes(8, bowl);
  EXPECT_NEAR(cell_sampling_error(grid), 0.25, 1e-12);
  EXPECT_NEAR(cell_sampling_error(grid, 100), 0.25, 1e-12);
}

TEST_F(UnitCellError, OfAStraightFieldIsNone) {
  EXPECT_LE(cell_sampling_error(cubes(6, straight)), 1e-13);
}

/// From a cell's middle to its corner along x: half a unit of |∂v/∂x| = 2.
TEST_F(UnitCellError, OfConstantCellsIsThatOfAStraightFieldAtTheirCorners) {
  const VectorAt shear = [](const Vec3& x) { return Vec3(2 * x.x, 0, 0); };
  const CellGrid grid = cubes(8, shear, CellValues::constant);
  EXPECT_NEAR(cell_sampling_error(grid), 1, 1e-12);
  EXPECT_NEAR(cell_sampling_error(grid, 100), 1, 1e-12);
}

/// A peak of one node is seen by all and, here, not by a lot of twenty of 729.
TEST_F(UnitCellError, ALotLooksAtSoManyNodes) {
  const VectorAt peak = [](const Vec3& x) { return Vec3(x == Vec3(4) ? 1 : 0, 0, 0); };
  const CellGrid grid = cubes(8, peak);
  EXPECT_GT(cell_sampling_error(grid), 0.1);
  EXPECT_LT(cell_sampling_error(grid, 20), cell_sampling_error(grid));
  EXPECT_EQ(cell_sampling_error(grid, 729), cell_sampling_error(grid));
  EXPECT_EQ(cell_sampling_error(grid, 20), cell_sampling_error(grid, 20));
}

}  // namespace
}  // namespace pellucid::fields
