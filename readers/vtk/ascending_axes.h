// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class vtkDataSet;

namespace pellucid::readers {

/// Turns the axes of an image or a rectilinear grid round that descend, such as latitudes from
/// north to south: their coordinates and the order of all values of points and cells, so that
/// every value stays where it is in the world, and vectors as they are. So are the axes of an
/// image whose directions run against the world's; those of a turned one are left, as are
/// coordinates that do neither, and all other data.
void make_axes_ascend(vtkDataSet& data);

}  // namespace pellucid::readers
