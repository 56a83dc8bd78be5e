// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

#include "fields/files/quantity.h"

class vtkDataSet;

namespace pellucid::fields {

/// A CellValues says what becomes of vectors that a file has at its cells: the mean of the cells
/// around each point, or one vector in the whole of a cell.
enum class CellValues { averaged, constant };

/// Vectors are three numbers for each point of a data set, or for each cell.
struct Vectors {
  vtkSmartPointer<vtkDataArray> values;
  bool of_cells = false;  // and constant in each
  bool averaged = false;  // to points, from cells
  std::string name;       // as pick_vectors() takes it; "" of an array without a name
  std::string title;      // what they are, for reports: "U", "U of the cells, averaged to points"
  Quantity quantity = Quantity::velocity;
};

/// Returns the vectors that `wanted` names: an array of three components; three arrays of one,
/// "U,V,W"; of a data set that is flat along one axis also two of these, the third being 0; of both
/// kinds of one name "point:NAME" or "cell:NAME". When it is empty they are the active ones, points
/// before cells, or the only ones that are no bytes, normals or texture coordinates. Vectors of
/// cells are averaged, or kept where `cells` says so; then arrays of points do not count. A scalar
/// is an array of one component, by its name. Throws InputError that lists the file's arrays when
/// there are none such.
Vectors pick_vectors(vtkDataSet& data, const std::string& wanted, CellValues cells,
                     const std::filesystem::path& path, Quantity quantity = Quantity::velocity);

}  // namespace pellucid::fields
