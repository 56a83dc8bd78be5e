// SPDX-License-Identifier: GPL-3.0-or-later
// The element (see scene/elements/elements.h) of a fragment.
uniform uint first_of_kind;  // of what is being drawn, among its kind of primitives
#ifdef DISC
uniform uint first_point_element;

int element() { return int(first_point_element + first_of_kind) + gl_PrimitiveID; }
#else
layout(binding = 11) uniform usamplerBuffer elements;

int element() {
  int primitive = int(first_of_kind) + gl_PrimitiveID;
#ifdef RIBBON
  primitive /= 2;  // triangles to a segment
#endif
  return int(texelFetch(elements, primitive).r);
}
#endif
