// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ray of a pixel enters or leaves a sphere, or the tube of a line: the formulas of
// groundtruth/shapes/round_solids.cpp, in double as there, so that they lose no digits but those of
// a picture's depths in float. After cast.glsl.
#include "oit/shapes/solid/solid_record.glsl"

// Three texels each: x, y; z, importance, opacity beside that of the colour; straight colour, opacity.
layout(binding = solid_points_texture) uniform usamplerBuffer solid_points;
const int POINT_TEXELS = 3;
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

#ifdef SPHERE
#include "oit/shapes/solid/sphere.glsl"
#else
#include "oit/shapes/solid/tube.glsl"
#endif
