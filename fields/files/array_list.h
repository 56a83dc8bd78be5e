// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

class vtkDataSet;

namespace pellucid::fields {

/// Returns what arrays of numbers a data set has, in one line: "U (point, 3 components, lengths 0 …
/// 2.5), p (cell, 1 component, -1 … 1)". Ranges are those of the finite values; "none" of none.
std::string describe_arrays(vtkDataSet& data);

}  // namespace pellucid::fields
