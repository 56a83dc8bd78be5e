// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/files/obj/obj_document.h"

namespace pellucid::geometry {

/// Returns the colour of each element by its material: that of the .mtl files beside the document,
/// light grey and opaque where there is none. Returns none when no element has a material of
/// theirs, or the vertices have colours, which come first. What is not drawn as the files say is
/// appended to `remarks`. Throws InputError "FILE:LINE: …" for an .mtl file that is not as the
/// format has it.
std::vector<Rgba> obj_element_colors(const ObjDocument& document, const ObjElements& elements,
                                     std::vector<std::string>& remarks);

}  // namespace pellucid::geometry
