// SPDX-License-Identifier: GPL-3.0-or-later
// What every method's geometry pass is given of a fragment, whatever the shape that it is of.
#define VARYING in
#include "oit/gl/bindings.glsl"
#include "oit/shapes/varyings.glsl"
#ifdef OPAQUE_CONTEXT
// Of the nearest opaque fragment.
layout(binding = opaque_keys_texture) uniform usampler2D opaque_keys;

uvec2 opaque_key() {
#ifdef HALF_RESOLUTION
  ivec2 pixel = min(2 * ivec2(gl_FragCoord.xy), textureSize(opaque_keys, 0) - 1);  // one of four
#else
  ivec2 pixel = ivec2(gl_FragCoord.xy);
#endif
  return texelFetch(opaque_keys, pixel, 0).xy;
}
#endif

#ifdef CAST
#include "oit/shapes/cast.glsl"
#else
// Of the primitives that are being drawn.
uint primitive_index() { return uint(gl_PrimitiveID); }
#endif

uniform uint first_primitive, last_primitive;  // of what is being drawn, in the order of the scene

struct Fragment {
  vec3 color;   // straight
  float alpha;  // opacity in [0, 1]
  float depth;  // d in [0, 1]: 0 the nearest, 1 the farthest depth of the scene
};

// The place in the order of the scene: by object, then by primitive.
uint primitive_order() { return min(first_primitive + primitive_index(), last_primitive); }

// The order of compositing: by depth, then by primitive. 0 precedes all of them.
uvec2 key_of(Fragment f) { return uvec2(floatBitsToUint(f.depth), primitive_order() + 1u); }

bool precedes(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

// |n . v|. See scene.h for the shapes' normals.
#ifdef LIT
#include "oit/shapes/lighting.glsl"
#ifdef CAST
float facing() { return cast_facing; }
#elif defined(DISC)
float facing() { return sqrt(1.0 - dot(vertex_corner, vertex_corner)); }
#else
vec3 view_direction() {
#ifdef ORTHOGRAPHIC
  return vec3(0.0, 0.0, 1.0);
#else
  return normalize(vertex_position);
#endif
}
#ifdef RIBBON
float facing() {
  float sine = length(cross(vertex_direction, view_direction()));
  float length_of_direction = length(vertex_direction);
  float profile = sqrt(max(1.0 - vertex_across * vertex_across, 0.0));
  return length_of_direction > 0.0 ? profile * sine / length_of_direction : 0.0;
}
#else
float facing() { return abs(dot(normalize(vertex_direction), view_direction())); }
#endif
#endif
#endif

#ifdef LIT_LATER
// A normal in the view frame: a mesh's, or one that the ray `v` meets at the angle of what a ribbon or
// a disc stands for.
vec3 shading_normal(vec3 v) {
#if defined(DISC) || defined(RIBBON)
  float c = facing();
  vec3 across = normalize(cross(v, abs(v.x) < 0.5 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
  return c * v + sqrt(max(1.0 - c * c, 0.0)) * across;
#else
  return normalize(vertex_direction);
#endif
}
#endif

#ifdef IMPORTANCE
// g and 1 - g, in [0, 1], by the smaller one, which has the digits.
vec2 importance() {
  vec2 g = clamp(vertex_importance, 0.0, 1.0);
  return g.x < g.y ? vec2(g.x, 1.0 - g.x) : vec2(1.0 - g.y, g.y);
}
#endif
#ifdef OPTIMIZED_FRAGMENTS
// The share of its opacity that a fragment keeps. Defined by the text that a program appends.
float optimized_opacity(vec2 importance, float depth);
#endif

// Also decides whether there is a fragment at all: a pass that needs nothing of it still calls it.
Fragment fragment() {
#ifdef DISC
  if (dot(vertex_corner, vertex_corner) > 1.0) discard;
#endif
#ifdef CAST
  if (!meet()) discard;
#endif
  // Interpolation may round an opacity or a depth of 1 to just above it.
  Fragment f = Fragment(vertex_color.rgb, clamp(vertex_color.a, 0.0, 1.0),
                        clamp(vertex_depth, 0.0, 1.0));
#if defined(LIT) && !defined(LIT_LATER)
  f.color = lit(f.color, facing());
#endif
#ifdef OPAQUE_CONTEXT
  if (precedes(opaque_key(), key_of(f))) discard;
#endif
#ifdef OPTIMIZED_FRAGMENTS
  f.alpha *= optimized_opacity(importance(), f.depth);
#endif
#ifdef OPTIMIZED_VERTICES
  f.alpha *= clamp(vertex_opacity, 0.0, 1.0);
#endif
  return f;
}
