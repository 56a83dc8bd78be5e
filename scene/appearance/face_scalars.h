// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/appearance/appearance.h"

namespace pellucid::scene {

/// Gives the mesh's vertices the scalars that `appearance` names and that only its faces have. A
/// vertex of faces of several values becomes one vertex for each, all with its normal: every face
/// is of one value then, and lit as before. Throws InputError for a scalar that neither have, with
/// those they have.
void bring_to_vertices(const Appearance& appearance, geometry::TriangleMesh& mesh);

}  // namespace pellucid::scene
