// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "geometry/vertices.h"

namespace pellucid::geometry {

/// Throws InputError "FILE: …" for a scalar that a file of this kind would not give back under its
/// name: one that the format cannot hold, or that means something else there, such as x, alpha or
/// importance. `also_taken` is a name that the file needs for itself.
///@{
void check_ply_names(const std::filesystem::path& path, const Vertices& vertices,
                     const char* also_taken = "");
void check_vtk_names(const std::filesystem::path& path, const Vertices& vertices);
///@}

}  // namespace pellucid::geometry
