// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkType.h>

#include <vector>

#include "geometry/files/mesh_formats.h"

class vtkDataArray;
class vtkDataSet;

namespace pellucid::geometry {

/// PointIds are numbers of VTK's points, or of its cells.
using PointIds = std::vector<vtkIdType>;

/// Returns the points' attributes, in the order of `points`: scalars by their name, vectors as
/// NAME_x, NAME_y, NAME_z, tensors of nine or six numbers as NAME_xx, NAME_xy, …, longer rows as
/// NAME_0, NAME_1, …, colours as red, green, blue, alpha, the active normals as nx, ny, nz.
/// VTK's own flags are none.
VertexAttributes vtk_attributes(vtkDataSet& data, const PointIds& points);

/// Returns the cells' numbers in the same way, in the order of `cells`: none of an array that has
/// not one tuple of each cell, nor colours and VTK's own flags.
VertexAttributes vtk_cell_scalars(vtkDataSet& data, const PointIds& cells);

/// Does what take_attributes() does, but for what simulations call so: an alpha without red, green
/// and blue is a scalar, unless the vertices are `colored` otherwise, and so is an importance
/// beyond [0, 1]. Remarks say it.
void take_vtk_attributes(VertexAttributes attributes, Vertices& vertices, bool colored = false);

/// Says of the bytes by which VTK draws, one grey or a grey and its opacity a point or cell
/// (COLOR_SCALARS of a legacy file), that they are scalars here, where nothing else is a colour.
void remark_greys(vtkDataSet& data, Vertices& vertices);

/// Returns the colours of cells, unless the points have some or the file has not one of each cell:
/// then nullptr.
vtkDataArray* vtk_cell_colors(vtkDataSet& data, const VertexAttributes& of_points);

/// Sets the columns red, green, blue and, of four components, alpha to the array's tuples.
void take_vtk_colors(vtkDataArray& array, const PointIds& tuples, VertexAttributes& attributes);

/// Returns what stands for 1 in an array of colours: 255 in bytes, else 1.
double vtk_color_unit(vtkDataArray& array);

}  // namespace pellucid::geometry
