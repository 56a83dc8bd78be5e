// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ray of a pixel enters or leaves a sphere, or the tube of a line: the formulas of
// groundtruth/shapes/round_solids.cpp, in double as there, so that they lose no digits but those of
// a picture's depths in float. View frame: view units, z the view depth, the eye at 0.
//
// All that decides is `precise`: passes have to agree to the last bit.
#include "oit/shapes/solid_record.glsl"
#include "oit/shapes/view.glsl"

// Three texels each: x, y; z, importance, opacity beside that of the colour; straight colour, opacity.
layout(binding = solid_points_texture) uniform usamplerBuffer solid_points;
const int POINT_TEXELS = 3;
uniform vec2 target_size;  // pixels

// What fragment.glsl interpolates of other shapes.
vec4 vertex_color;
vec2 vertex_importance;
float vertex_depth, vertex_opacity;
vec3 vertex_direction;  // the outer normal
float solid_facing;     // |n . v|

// Of the primitives that are being drawn: a crossing has the two triangles of a rectangle.
uint primitive_index() { return uint(gl_PrimitiveID) / 2u; }
bool leaves() { return primitive_index() % 2u == 1u; }

struct SolidPoint {
  dvec3 position;
  float importance, opacity;
};

SolidPoint load_point(int i) {
  uvec4 xy = texelFetch(solid_points, POINT_TEXELS * i);
  uvec4 zio = texelFetch(solid_points, POINT_TEXELS * i + 1);
  return SolidPoint(dvec3(packDouble2x32(xy.xy), packDouble2x32(xy.zw), packDouble2x32(zio.xy)),
                    uintBitsToFloat(zio.z), uintBitsToFloat(zio.w));
}

vec4 load_color(int i) { return uintBitsToFloat(texelFetch(solid_points, POINT_TEXELS * i + 2)); }

double radius_of(int solid) {
  return packDouble2x32(texelFetch(solids, SOLID_TEXELS * solid + 1).zw);
}

uvec4 links_of(int solid) { return texelFetch(solids, SOLID_TEXELS * solid + 2); }

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

// A ray seen from a point: offset + t direction, t = 0 where it is nearest.
struct LocalRay {
  dvec3 offset, direction;
  double nearest_depth;
};

LocalRay local_ray(Ray ray, dvec3 origin) {
  precise dvec3 to_origin = origin - ray.start;
  precise double t = dot(to_origin, ray.direction);
  precise dvec3 offset = t * ray.direction - to_origin;
  precise double nearest_depth = ray.start.z + t * ray.direction.z;
  return LocalRay(offset, ray.direction, nearest_depth);
}

// Chords: from and to which t, or view depth, a ray is in a convex solid; none if to < from.
const double ENDLESS = 1e300lf;
const dvec2 no_chord = dvec2(ENDLESS, -ENDLESS);

bool has_chord(dvec2 chord) { return chord.x < chord.y; }

// Around the t that is nearest, where the ray comes as near to the middle as `distance`; `a`: the
// square of what a t of 1 is across.
dvec2 round_chord(double nearest, double distance, double a, double radius) {
  precise double rest = (radius - distance) * (radius + distance);
  if (!(rest > 0.0lf)) return no_chord;
  precise double half_length = sqrt(rest / a);
  precise dvec2 chord = dvec2(nearest - half_length, nearest + half_length);
  return chord;
}

// The ray is seen from the ball's centre.
dvec2 ball_chord(LocalRay ray, double radius) {
  precise double nearest = -dot(ray.offset, ray.direction);
  precise dvec3 across = ray.offset + nearest * ray.direction;
  precise double distance = sqrt(dot(across, across));
  return round_chord(nearest, distance, 1.0lf, radius);
}

// Returns whether the ray is in front of the eye there.
bool set_depth(double depth) {
  precise double d = (depth - view_depth.x) / view_depth.y;
  vertex_depth = float(d);
  return depth > 0.0lf;
}

#ifdef SPHERE
#include "oit/shapes/sphere.glsl"
#else
#include "oit/shapes/tube.glsl"
#endif
