// SPDX-License-Identifier: GPL-3.0-or-later
// The element (see scene/elements/elements.h) of a fragment.
#include "oit/gl/bindings.glsl"

uniform uint first_of_kind, last_of_kind;  // of what is being drawn, among its kind of primitives

int primitive_of_kind() { return int(min(first_of_kind + uint(gl_PrimitiveID), last_of_kind)); }

#ifdef DISC
uniform uint first_point_element;

int element() { return int(first_point_element) + primitive_of_kind(); }
#else
#ifdef RIBBON
layout(binding = segment_elements_texture) uniform usamplerBuffer elements;
const int triangles_of_primitive = 2;  // of a segment
#else
layout(binding = triangle_elements_texture) uniform usamplerBuffer elements;
const int triangles_of_primitive = 1;
#endif

int element() {
  return int(texelFetch(elements, primitive_of_kind() / triangles_of_primitive).r);
}
#endif
