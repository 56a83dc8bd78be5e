// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace pellucid::readers {

/// Makes VTK's reader of MRC files. Bytes are signed where the file is of the format of 2014, or
/// IMOD says so. Throws InputError for unsigned numbers of 16 bits (mode 6), of which VTK makes two
/// where there is one, and for axes in another order than x, y, z, which VTK does not look at.
vtkSmartPointer<vtkAlgorithm> make_mrc(const std::filesystem::path& path);

}  // namespace pellucid::readers
