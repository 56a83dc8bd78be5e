// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

class vtkDataArray;
class vtkDataSet;

namespace pellucid::fields {

/// Returns the point array `name`; or, when it is empty, the active vectors or else the only array
/// with three components. Throws InputError that lists the file's vector arrays when there is no
/// such array, and when it does not have one vector a point.
vtkDataArray* pick_vectors(vtkDataSet* data, const std::string& name,
                           const std::filesystem::path& path);

}  // namespace pellucid::fields
