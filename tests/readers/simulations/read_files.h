// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmock/gmock.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>

#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"
#include "readers/vtk/vtk_file.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::readers {

/// Files that a test writes, as they are read.
class ReadFiles : public ::testing::Test {
 protected:
  /// Returns the first `count` numbers of the only point array, point after point.
  static std::vector<double> values(const std::filesystem::path& file, int count) {
    const auto data = read_vtk_data_set(file);
    vtkDataArray* array = data->GetPointData()->GetArray(0);
    std::vector<double> result;
    for (int i = 0; i < count; ++i)
      result.push_back(array->GetComponent(i / array->GetNumberOfComponents(),
                                           i % array->GetNumberOfComponents()));
    return result;
  }

  /// Returns why the file is refused.
  static std::string complaint(const std::filesystem::path& file) {
    try {
      read_vtk_data_set(file);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }

  testing::TemporaryFolder folder_;
};

}  // namespace pellucid::readers
