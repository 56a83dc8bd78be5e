// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

class vtkPointSet;

namespace pellucid::readers {

/// Puts the points that vtkTecplotReader made where the variables have them that are coordinates by
/// their names: "X", "CoordinateX", "x(m)", "X [m]". VTK takes others: a variable "K", as energy is
/// called, for z before "Z", "Z_vorticity" for z where there is none, "Z [m]" for none. What it
/// took becomes an array of the points.
void place_points(vtkPointSet& data, std::span<const std::string> variables);

}  // namespace pellucid::readers
