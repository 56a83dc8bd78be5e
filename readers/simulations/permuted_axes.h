// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

class vtkImageData;
class vtkRectilinearGrid;

namespace pellucid::readers {

/// Make axis `a` of the grid its axis `order[a]`, a permutation of 0 to 2: coordinates or spacing,
/// and the order of all values of points; vectors and an image's origin stay as they are. The grid
/// has no values of cells.
///@{
void permute_axes(vtkRectilinearGrid& grid, const std::array<int, 3>& order);
void permute_axes(vtkImageData& image, const std::array<int, 3>& order);
///@}

}  // namespace pellucid::readers
