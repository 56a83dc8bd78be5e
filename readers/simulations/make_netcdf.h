// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pellucid::readers {

/// Makes VTK's reader of NetCDF files, on axes as the file has them. Samples that are missing are
/// NaN: those that `_FillValue` or `missing_value` name, those outside of `valid_min`, `valid_max`
/// or `valid_range`, and, in a variable without a _FillValue, those that were never written.
/// Axes of space are those that axis_order() names. Heights that count downwards (positive="down")
/// are negative.
vtkSmartPointer<vtkAlgorithm> make_netcdf(const std::filesystem::path& path);

/// Has a reader of make_netcdf() read the variables of one set of dimensions, time apart: that of
/// those named in `wanted`, or else the largest set, of the most variables, that the file has
/// first. Returns what other variables there are, with their dimensions, those without any apart.
/// Throws InputError where the wanted ones differ in their dimensions.
std::vector<std::string> pick_netcdf_variables(vtkAlgorithm& reader, const std::string& wanted);

}  // namespace pellucid::readers
