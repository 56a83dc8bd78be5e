// SPDX-License-Identifier: GPL-3.0-or-later
// The element (see scene/elements/elements.h) of a fragment.
#include "oit/gl/bindings.glsl"

// After fragment.glsl.
uniform uint first_of_kind, last_of_kind;  // of what is being drawn, among its kind of primitives

int primitive_of_kind() { return int(min(first_of_kind + primitive_index(), last_of_kind)); }

#if defined(ISOSURFACE) || defined(FADING_ISOSURFACE)
int element() { return -1; }  // none: it keeps its opacity, and has no importance
#elif defined(DISC) || defined(SPHERE)
#ifdef DISC
const int primitives_of_point = 1;
#else
const int primitives_of_point = 2;
#endif
#if !(defined(SPHERE) && defined(OPTIMIZED_VERTICES))  // else solid.glsl has them
uniform uint first_point_element, others;
#endif

int element() {
  return int(first_point_element + others) + primitive_of_kind() / primitives_of_point;
}
#else
uniform uint others;  // points, or segments, of the other kind that stand before
#if defined(RIBBON) || defined(TUBE)
layout(binding = segment_elements_image, r32ui) readonly uniform uimageBuffer elements;
const int triangles_of_primitive = 2;  // of a segment; of a tube crossings
#else
layout(binding = triangle_elements_image, r32ui) readonly uniform uimageBuffer elements;
const int triangles_of_primitive = 1;
#endif

int element() {
  return int(imageLoad(elements, int(others) + primitive_of_kind() / triangles_of_primitive).r);
}
#endif
