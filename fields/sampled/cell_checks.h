// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace pellucid::fields {

/// Returns the volume cells of a grid, without those of lower dimension and those that it hides.
/// Throws InputError, naming `path`, where a cell is of another kind, and for fewer than two
/// samples along an axis of a structured grid.
vtkSmartPointer<vtkDataSet> checked_volume(vtkDataSet* data, const std::filesystem::path& path);

}  // namespace pellucid::fields
