// SPDX-License-Identifier: GPL-3.0-or-later
// The element (see scene/elements/elements.h) of a fragment.
#include "oit/gl/bindings.glsl"

uniform uint first_of_kind;  // of what is being drawn, among its kind of primitives
#ifdef DISC
uniform uint first_point_element;

int element() { return int(first_point_element + first_of_kind) + gl_PrimitiveID; }
#else
#ifdef RIBBON
layout(binding = segment_elements_texture) uniform usamplerBuffer elements;
const int triangles_of_primitive = 2;  // of a segment
#else
layout(binding = triangle_elements_texture) uniform usamplerBuffer elements;
const int triangles_of_primitive = 1;
#endif

int element() {
  int primitive = (int(first_of_kind) + gl_PrimitiveID) / triangles_of_primitive;
  return int(texelFetch(elements, primitive).r);
}
#endif
