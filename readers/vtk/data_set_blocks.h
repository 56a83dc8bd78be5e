// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// VTK's data sets as blocks, from the process that parses a file to the one that uses it:
//
//     kind                                  image | rectilinear | structured | unstructured | poly
//     extent                                6 × i32: of image, rectilinear and structured data
//     origin, spacing, direction            3, 3 and 9 (row by row) × f64: of an image
//     x, y, z                               coordinates along the axes of rectilinear data
//     points                                three numbers each, of the three other kinds
//     types                                 u8: VTK's number of each unstructured cell's type
//     faces, face_locations                 i64, as VTK keeps polyhedra
//     G.offsets, G.connectivity             i64: cells G of unstructured, verts, lines, polys and
//                                           strips of poly data
//     point:NAME, cell:NAME                 arrays of the points and cells
//     point.active, cell.active             4 × i32: scalars, vectors, normals, texture coordinates
//                                           by number, or -1

#include <vtkSmartPointer.h>

#include "core/files/blocks.h"

class vtkDataSet;

namespace pellucid::readers {

/// Whether somebody reads the arrays of a data set after it was written.
enum class Numbers { kept, for_once };

/// Writes a data set as it is. Nothing that it says is trusted or looked at, so that a library may
/// have filled it from any file; arrays of texts are left out. Large arrays `for_once` go back to
/// the system as they are written, where nothing else refers to them.
void write_data_set(vtkDataSet& data, BlockWriter& out, Numbers use = Numbers::kept);

/// Builds the data set anew. Throws BlockError when an offset, an index or a number of points,
/// cells or values does not fit the others: every cell of the result can be used by VTK's filters.
/// Accepted cells are those of VTK's linear and quadratic types and polyhedra.
vtkSmartPointer<vtkDataSet> data_set_of(const Blocks& blocks);

}  // namespace pellucid::readers
