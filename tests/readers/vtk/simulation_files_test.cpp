// SPDX-License-Identifier: GPL-3.0-or-later
// What the formats of simulations mean, where VTK's readers by themselves take something else.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include "core/error.h"
#include "core/files/output_file.h"
#include "readers/vtk/vtk_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

class UnitSimulationFiles : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
};

/// The vectors that a field takes unless told otherwise, of one point.
std::vector<double> active_vector(vtkDataSet& data, vtkIdType point) {
  vtkDataArray* vectors = data.GetPointData()->GetVectors();
  if (!vectors) return {};
  return {vectors->GetComponent(point, 0), vectors->GetComponent(point, 1),
          vectors->GetComponent(point, 2)};
}

/// Eight lines of a value each.
std::string column(double value) {
  std::string text;
  for (int i = 0; i < 8; ++i) text += fmt::format("{}\n", value);
  return text;
}

TEST_F(UnitSimulationFiles, Plot3dVectorsAreMomentumOverDensity) {
  std::string places;
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < 8; ++i) places += fmt::format("{}\n", i >> axis & 1);
  write_text(folder_ / "p.xyz", "2 2 2\n" + places);
  write_text(folder_ / "p.q", "2 2 2\n0.5 0 1 0\n" + column(4) + column(2) + column(-3) +
                                  column(1) + column(10));
  const auto data = read_vtk_data_set(folder_ / "p.xyz");
  EXPECT_STREQ(data->GetPointData()->GetVectors()->GetName(), "Velocity");
  EXPECT_THAT(active_vector(*data, 7), ElementsAre(0.5, -0.75, 0.25));
}

}  // namespace
}  // namespace pellucid::readers
