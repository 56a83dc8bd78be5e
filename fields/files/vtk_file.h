// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkDataArray;
class vtkDataSet;

namespace pellucid::fields {

/// Reads .vti, .vtr, .vts, .vtu and legacy .vtk with VTK's readers. Throws InputError for a file
/// without points, a truncated one, and whatever else VTK would print about it.
vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path);

/// Returns the point array `name`; or, when it is empty, the active vectors or else the only array
/// with three components. Throws InputError that lists the file's vector arrays when there is no
/// such array, and when it does not have one vector a point.
vtkDataArray* pick_vectors(vtkDataSet* data, const std::string& name,
                           const std::filesystem::path& path);

}  // namespace pellucid::fields
