// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "geometry/line_set.h"
#include "geometry/triangle_mesh.h"
#include "scene/appearance/appearance.h"

namespace pellucid::scene {

/// Returns the largest part of the colour map, in [0, 1], that lies between two corners of one
/// triangle, or two ends of one segment, by the scalar of `by`: colours are of the map at vertices
/// alone, and linear in red, green and blue between them. The vertices have the scalar.
///@{
double map_span(const ScalarColor& by, const geometry::TriangleMesh& mesh);
double map_span(const ScalarColor& by, const geometry::LineSet& lines);
///@}

/// Says in the vertices' remarks that `span` of the map is bridged so, when it is over a tenth; an
/// earlier such remark goes.
void remark_map_span(double span, std::string_view what, geometry::Vertices& vertices);

}  // namespace pellucid::scene
