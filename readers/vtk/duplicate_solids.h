// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

class vtkDataSet;

namespace pellucid::readers {

/// Returns what shown_cells() does, and the duplicates that have a volume, with their marks: a face
/// between a cell and a duplicate bounds nothing.
vtkSmartPointer<vtkDataSet> cells_and_duplicate_solids(vtkDataSet* data);

}  // namespace pellucid::readers
