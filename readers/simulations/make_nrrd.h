// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace pellucid::readers {

/// Reads an NRRD image by Teem's own library: one number a sample, or a row of some, called "NRRD".
/// It is placed by its space directions or spacings, anatomical spaces as RAS; vectors of three
/// numbers are turned with it, from its measurement frame where it has one. Throws InputError that
/// names the file for what Teem complains of, for samples over time, for spaces of other than three
/// dimensions and for data in files that a pattern of numbers names.
vtkSmartPointer<vtkAlgorithm> make_nrrd(const std::filesystem::path& path);

}  // namespace pellucid::readers
