// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// VTK's readers: for the process that pellucid-read-vtk is, and no other.

#include <vtkSmartPointer.h>

#include <filesystem>

class vtkDataSet;

namespace pellucid::readers {

/// Parses .vti, .vtr, .vts, .vtu, .vtp and legacy .vtk with VTK's readers, which a wrong file may
/// crash. Throws InputError for a file without points, a truncated one, and whatever else VTK would
/// print about it.
vtkSmartPointer<vtkDataSet> parse_vtk_file(const std::filesystem::path& path);

}  // namespace pellucid::readers
