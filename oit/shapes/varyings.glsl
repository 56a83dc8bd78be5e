// SPDX-License-Identifier: GPL-3.0-or-later
// What the vertex shaders hand to the fragment shaders. Whoever includes this defines VARYING, as
// out or in.
#if defined(SPHERE) || defined(TUBE) || defined(ISOSURFACE) || defined(FADING_ISOSURFACE)
#define CAST  // by the ray of a pixel
#endif

// What is interpolated of an importance g: g and 1 - g. Rounding takes 6e-8 from a constant 1, but
// nothing from a constant 0; energies have a power of 1 - g times weights of up to any size.
vec2 interpolated_importance(float g) { return vec2(g, 1.0 - g); }

#ifdef CAST
layout(location = 0) flat VARYING int vertex_record;  // see cast.glsl, which has all the others
#else
#ifdef DISC
#define OF_SHAPE flat  // one value for a whole disc
#else
#define OF_SHAPE
#endif
layout(location = 0) OF_SHAPE VARYING vec4 vertex_color;   // straight colour, opacity
layout(location = 1) OF_SHAPE VARYING float vertex_depth;  // d
#ifdef DISC
layout(location = 2) VARYING vec2 vertex_corner;  // units of the radius from the centre
#elif defined(LIT)
layout(location = 2) VARYING vec3 vertex_direction;  // a mesh's normal, a line's direction; view frame
layout(location = 3) VARYING vec3 vertex_position;   // view frame, the eye at 0
#ifdef RIBBON
layout(location = 4) VARYING float vertex_across;  // -1 … 1 from one rim to the other
#endif
#endif
#ifdef IMPORTANCE
layout(location = 5) OF_SHAPE VARYING vec2 vertex_importance;  // see interpolated_importance()
#endif
#ifdef OPTIMIZED_VERTICES
layout(location = 6) OF_SHAPE VARYING float vertex_opacity;
#endif
#endif
