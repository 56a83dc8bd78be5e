// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ray of a pixel enters or leaves a sphere, or the tube of a line: the formulas of
// groundtruth/shapes/round_solids.cpp, in double as there, so that they lose no digits but those of
// a picture's depths in float. View frame: view units, z the view depth, the eye at 0.
//
// A tube is one solid, all within the radius of its line. A segment's crossing counts where it lies
// in none of the segments of the same line that overlap this one: the sum over chords of
// groundtruth/traversal/solid_union.cpp, read for one chord.
//
// All that decides is `precise`: passes have to agree to the last bit.
#include "oit/shapes/solid_record.glsl"
#include "oit/shapes/view.glsl"

// Three texels each: x, y; z, importance, opacity beside that of the colour; straight colour, opacity.
layout(binding = solid_points_texture) uniform usamplerBuffer solid_points;
const int POINT_TEXELS = 3;
uniform vec2 target_size;  // pixels
#ifdef OPTIMIZED_VERTICES
#ifdef SPHERE
uniform uint first_point_element, others;  // see element.glsl
layout(binding = element_opacities_texture) uniform usamplerBuffer element_opacities;
#endif
#endif

// What fragment.glsl interpolates of other shapes.
vec4 vertex_color;
float vertex_depth, vertex_importance, vertex_opacity;
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

// Chords: from and to which t a ray is in a convex solid; none if to <= from.
const double ENDLESS = 1e300lf;
const dvec2 no_chord = dvec2(ENDLESS, -ENDLESS);

// Around the t that is nearest, where the ray comes as near to the middle as `distance`; `a`: the
// square of what a t of 1 is across.
dvec2 round_chord(double nearest, double distance, double a, double radius) {
  precise double rest = (radius - distance) * (radius + distance);
  if (!(rest > 0.0lf)) return no_chord;
  precise double half_length = sqrt(rest / a);
  precise dvec2 chord = dvec2(nearest - half_length, nearest + half_length);
  return chord;
}

dvec2 ball_chord(LocalRay ray, dvec3 center, double radius) {
  precise double nearest = dot(center - ray.offset, ray.direction);
  precise dvec3 across = ray.offset + nearest * ray.direction - center;
  precise double distance = sqrt(dot(across, across));
  return round_chord(nearest, distance, 1.0lf, radius);
}

#ifdef TUBE
layout(binding = solid_overlaps_texture) uniform usamplerBuffer solid_overlaps;

// Of the cylinder around the axis through the origin, without ends.
dvec2 endless_cylinder_chord(dvec3 offset_across, dvec3 direction_across, double radius) {
  const double parallel = 1e-12lf;  // a sine below which there is rounding alone
  precise double a = dot(direction_across, direction_across);
  if (a < parallel * parallel)
    return dot(offset_across, offset_across) >= radius * radius ? no_chord
                                                                : dvec2(-ENDLESS, ENDLESS);
  precise double nearest = -dot(offset_across, direction_across) / a;
  precise dvec3 p = offset_across + nearest * direction_across;
  precise double distance = sqrt(dot(p, p));
  return round_chord(nearest, distance, a, radius);
}

// Between the planes at ±half along the axis.
dvec2 slab_chord(double x, double dx, double half_length) {
  if (dx == 0.0lf) return abs(x) < half_length ? dvec2(-ENDLESS, ENDLESS) : no_chord;
  precise double t0 = (-half_length - x) / dx;
  precise double t1 = (half_length - x) / dx;
  return dvec2(min(t0, t1), max(t0, t1));
}

dvec2 cylinder_chord(LocalRay ray, dvec3 half_axis, double radius) {
  precise double half_length = sqrt(dot(half_axis, half_axis));
  if (!(half_length > 0.0lf)) return no_chord;
  precise dvec3 axis = half_axis / half_length;
  precise double x = dot(ray.offset, axis);
  precise double dx = dot(ray.direction, axis);
  precise dvec3 offset_across = ray.offset - x * axis;
  precise dvec3 direction_across = ray.direction - dx * axis;
  dvec2 around = endless_cylinder_chord(offset_across, direction_across, radius);
  dvec2 along = slab_chord(x, dx, half_length);
  dvec2 chord = dvec2(max(around.x, along.x), min(around.y, along.y));
  return chord.x < chord.y ? chord : no_chord;
}

// A capsule is convex: its chord spans those of its parts.
dvec2 capsule_chord(LocalRay ray, dvec3 half_axis, double radius) {
  dvec2 a = ball_chord(ray, -half_axis, radius);
  dvec2 b = ball_chord(ray, half_axis, radius);
  dvec2 c = cylinder_chord(ray, half_axis, radius);
  return dvec2(min(min(a.x, b.x), c.x), max(max(a.y, b.y), c.y));
}

struct Segment {
  LocalRay ray;
  dvec3 half_axis;
  dvec2 chord, depths;  // view depths of the chord's ends
};

Segment cast_at(int solid, Ray ray) {
  int first = int(links_of(solid).x);
  precise dvec3 a = load_point(first).position;
  precise dvec3 half_axis = 0.5lf * (load_point(first + 1).position - a);
  LocalRay local = local_ray(ray, a + half_axis);
  dvec2 chord = capsule_chord(local, half_axis, radius_of(solid));
  precise dvec2 depths = dvec2(local.nearest_depth) + chord * local.direction.z;
  return Segment(local, half_axis, chord, depths);
}

// Crossings of a line in order: by depth, entries first, by segment.
bool is_within(int solid, dvec2 depths, int other, dvec2 others) {
  if (leaves())
    return others.x <= depths.y && (depths.y < others.y || (depths.y == others.y && solid < other));
  return (others.x < depths.x || (others.x == depths.x && other < solid)) && depths.x <= others.y;
}

bool has_chord(Segment segment) { return segment.chord.x < segment.chord.y; }

// Returns whether the ray's crossing with a segment is one with its line. (One loop for it and for
// those that it overlaps: a driver compiles the cast once.)
bool meet_line(int solid, Ray ray, out Segment segment) {
  uvec4 links = links_of(solid);
  bool meets = true;
  for (uint i = 0u; meets && i <= links.z; ++i) {
    int other = i == 0u ? solid : int(texelFetch(solid_overlaps, int(links.y + i - 1u)).r);
    Segment found = cast_at(other, ray);
    if (i == 0u) {
      segment = found;
      meets = has_chord(found);
    } else {
      meets = !has_chord(found) || !is_within(solid, segment.depths, other, found.depths);
    }
  }
  return meets;
}
#endif

// Returns whether the ray is in front of the eye there.
bool set_depth(double depth) {
  precise double d = (depth - view_depth.x) / view_depth.y;
  vertex_depth = float(d);
  return depth > 0.0lf;
}

#ifdef SPHERE
void set_vertex(int point, SolidPoint from) {
  vertex_color = load_color(point);
  vertex_importance = from.importance;
#ifdef OPTIMIZED_VERTICES
  uint element = first_point_element + others + uint(point);
  vertex_opacity = uintBitsToFloat(texelFetch(element_opacities, int(element)).r);
#endif
}

// Returns whether there is a fragment.
bool meet_solid() {
  int point = int(links_of(vertex_solid).x);
  SolidPoint center = load_point(point);
  double radius = radius_of(vertex_solid);
  LocalRay ray = local_ray(pixel_ray_of_target(), center.position);
  dvec2 chord = ball_chord(ray, dvec3(0.0lf), radius);
  if (!(chord.x < chord.y)) return false;
  set_vertex(point, center);
  precise double t = leaves() ? chord.y : chord.x;
  vertex_direction = vec3((ray.offset + t * ray.direction) / radius);
  // At the ends of the chord n . v is half its length over the radius.
  solid_facing = float(0.5lf * (chord.y - chord.x) / radius);
  return set_depth(ray.nearest_depth + t * ray.direction.z);
}
#else
void set_vertices(int first, float along) {
  SolidPoint a = load_point(first), b = load_point(first + 1);
  vertex_color = mix(load_color(first), load_color(first + 1), along);
  vertex_importance = mix(a.importance, b.importance, along);
  vertex_opacity = mix(a.opacity, b.opacity, along);
}

// Returns whether there is a fragment.
bool meet_solid() {
  Ray ray = pixel_ray_of_target();
  Segment segment;
  if (!meet_line(vertex_solid, ray, segment)) return false;
  dvec3 x = segment.ray.offset + (leaves() ? segment.chord.y : segment.chord.x) *
                                     segment.ray.direction;
  double squared = dot(segment.half_axis, segment.half_axis);
  double along = squared > 0.0lf ? clamp(dot(x, segment.half_axis) / squared, -1.0lf, 1.0lf) : 0.0lf;
  set_vertices(int(links_of(vertex_solid).x), float(0.5lf + 0.5lf * along));
  dvec3 normal = (x - along * segment.half_axis) / radius_of(vertex_solid);
  vertex_direction = vec3(normal);
  solid_facing = min(float(abs(dot(normal, segment.ray.direction))), 1.0);
  return set_depth(leaves() ? segment.depths.y : segment.depths.x);
}
#endif
