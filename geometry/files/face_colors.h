// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/files/from_file.h"

namespace pellucid::geometry {

/// FaceColors are colours of triangles, one each.
struct FaceColors {
  std::vector<Rgba> colors;
  bool have_alpha = true;  // of their own: else 1
};

/// Gives each triangle one colour, `faces` has as many, in the place of the vertices'. Faces
/// without an alpha leave the vertices theirs; where both have one, a remark says that the
/// vertices' is left out. A vertex of triangles of several colours becomes one vertex for each;
/// those of no triangle are left out. The scalars of the vertices as they were become the file's
/// `values`.
void color_faces(const FaceColors& faces, FileMesh& mesh);

}  // namespace pellucid::geometry
