// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn by casting the ray of a pixel: its ray, and what fragment.glsl interpolates of other
// shapes. View frame: view units, z the view depth, the eye at 0.
//
// All that decides is `precise`: passes have to agree to the last bit.
#include "oit/shapes/view.glsl"

uniform vec2 target_size;  // pixels

// Set by meet(), which returns whether there is a fragment.
vec4 vertex_color;
vec2 vertex_importance;
float vertex_depth, vertex_opacity;
vec3 vertex_direction;  // the outer normal
float cast_facing;     // |n . v|

// Of the primitives that are being drawn: a crossing has the two triangles of a rectangle.
uint primitive_index() { return uint(gl_PrimitiveID) / 2u; }

const double ENDLESS = 1e300lf;

struct Ray {
  dvec3 start, direction;  // unit length
};

Ray pixel_ray_of_target() {
  precise dvec2 clip = (2.0lf * dvec2(gl_FragCoord.xy) - dvec2(target_size)) / dvec2(target_size);
  precise dvec2 xy = (clip - ray_shift) * ray_scale;
#ifdef ORTHOGRAPHIC
  return Ray(dvec3(xy, 0.0lf), dvec3(0.0lf, 0.0lf, 1.0lf));
#else
  precise double size = sqrt(xy.x * xy.x + xy.y * xy.y + 1.0lf);
  precise dvec3 direction = dvec3(xy, 1.0lf) / size;
  return Ray(dvec3(0.0lf), direction);
#endif
}

// Returns whether the ray is in front of the eye there.
bool set_depth(double depth) {
  precise double d = (depth - view_depth.x) / view_depth.y;
  vertex_depth = float(d);
  return depth > 0.0lf;
}

#if defined(SPHERE) || defined(TUBE)
#include "oit/shapes/solid/solid.glsl"
#else
#include "oit/shapes/isosurface/isosurface.glsl"
#endif
