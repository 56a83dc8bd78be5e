// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>

#include <string>

namespace pellucid::readers {

/// Returns times of a file in ascending order. VTK takes the first and then those alone that are
/// later than all before. Throws InputError, after `file`, for two that are the same and one that
/// is no number.
vtkSmartPointer<vtkDoubleArray> ascending_times(vtkDoubleArray& times, const std::string& file);

/// Returns in place of a file's times others by which VTK loads `time`, or the next one if the file
/// has none such: it takes the first that is not before.
vtkSmartPointer<vtkDoubleArray> times_to_load(vtkDoubleArray& times, double time);

}  // namespace pellucid::readers
