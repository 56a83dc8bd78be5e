// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>

class vtkDataSet;

namespace pellucid::readers {

/// Reads .vti, .vtr, .vts, .vtu, .vtp and legacy .vtk by VTK, in a process of its own. Every
/// offset, index and number of values in the result has been checked. Throws InputError that names
/// the file for a file without points, a truncated one, what VTK complains of and what it dies
/// over.
vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path);

}  // namespace pellucid::readers
