// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace pellucid::readers {

/// Makes VTK's reader of NetCDF files, on axes as the file has them. Samples that are missing are
/// NaN: those that `_FillValue` or `missing_value` name, those outside of `valid_min`, `valid_max`
/// or `valid_range`, and, in a variable without a _FillValue, those that were never written.
vtkSmartPointer<vtkAlgorithm> make_netcdf(const std::filesystem::path& path);

}  // namespace pellucid::readers
