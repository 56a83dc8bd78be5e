// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

class vtkDataArray;
class vtkDataSet;

namespace pellucid::fields {

/// Reads .vti, .vtr, .vts, .vtu and legacy .vtk with VTK's readers. Whatever VTK would
/// print becomes the InputError that is thrown instead.
vtkSmartPointer<vtkDataSet> read_vtk_data_set(const std::filesystem::path& path);

/// The point array `name`; or, when it is empty, the active vectors or else the only array with
/// three components. Throws InputError that lists the file's vector arrays.
vtkDataArray* pick_vectors(vtkDataSet* data, const std::string& name,
                           const std::filesystem::path& path);

}  // namespace pellucid::fields
