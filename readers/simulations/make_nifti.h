// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace pellucid::readers {

/// Makes VTK's reader of NIfTI files. Values are what the file's scl_slope and scl_inter make of
/// its numbers; a slope of 0, or one that is no number, is none. Images of several volumes over
/// time are refused by InputError when they are read.
vtkSmartPointer<vtkAlgorithm> make_nifti(const std::filesystem::path& path);

}  // namespace pellucid::readers
