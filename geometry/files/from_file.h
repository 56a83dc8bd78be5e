// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/line_set.h"
#include "geometry/triangle_mesh.h"

namespace pellucid::geometry {

/// A FromFile is a shape as a file has it. Where vertices repeat the file's numbers, since those of
/// a face are at each of its corners, or since a vertex has become several, `values` holds the
/// scalars as the file has them, once each, by name: percentiles are of these.
template <class Shape>
struct FromFile : Shape {
  std::map<std::string, std::vector<double>> values;
};
/// A FileMesh is a mesh as a file has it.
using FileMesh = FromFile<TriangleMesh>;
/// A FileLines is a set of polylines as a file has it.
using FileLines = FromFile<LineSet>;

/// Takes the numbers of a file's faces, once each, into `values`; those that its vertices have a
/// scalar of the same name for are not asked for.
void take_face_values(std::map<std::string, std::vector<double>> values, FileMesh& mesh);

}  // namespace pellucid::geometry
