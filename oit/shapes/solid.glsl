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
  return has_chord(chord) ? chord : no_chord;
}

const int BALL_A = 0, BALL_B = 1, CYLINDER = 2;

// A segment as the ray meets it.
struct Segment {
  dvec2 depths;     // where the ray enters and leaves; no_chord if it does not meet it
  dvec3 half_axis;  // from the end that comes first in the order of coordinates
  bool backwards;   // that is the second end
  // Of the end that is drawn: the part it lies on, the ray from that part's centre, its t.
  int part;
  LocalRay ray;
  double t;
};

bool meets_ray(Segment segment) { return segment.depths.x <= segment.depths.y; }

void widen(inout Segment segment, int part, LocalRay ray, dvec2 chord) {
  precise dvec2 depths = dvec2(ray.nearest_depth) + chord * ray.direction.z;
  bool sooner = depths.x < segment.depths.x, later = depths.y > segment.depths.y;
  if (sooner) segment.depths.x = depths.x;
  if (later) segment.depths.y = depths.y;
  if (!(leaves() ? later : sooner)) return;
  segment.part = part;
  segment.ray = ray;
  segment.t = leaves() ? chord.y : chord.x;
}

// By x, then y, then z.
bool in_coordinate_order(dvec3 p, dvec3 q) {
  return p.x < q.x || (p.x == q.x && (p.y < q.y || (p.y == q.y && p.z < q.z)));
}

// A capsule is convex: its chord spans those of its parts. Each end is computed from the centre of
// its part: segments that share a ball, or a cylinder from either side, have the same bits.
Segment cast_at(int solid, Ray ray) {
  int first = int(links_of(solid).x);
  double radius = radius_of(solid);
  dvec3 a = load_point(first).position, b = load_point(first + 1).position;
  bool backwards = in_coordinate_order(b, a);
  precise dvec3 half_axis = 0.5lf * (backwards ? a - b : b - a);
  precise dvec3 middle = (backwards ? b : a) + half_axis;
  LocalRay local = local_ray(ray, a);
  Segment segment = Segment(no_chord, half_axis, backwards, BALL_A, local, 0.0lf);
  for (int part = BALL_A; part <= CYLINDER; ++part) {
    if (part != BALL_A) local = local_ray(ray, part == BALL_B ? b : middle);
    dvec2 chord = part == CYLINDER ? cylinder_chord(local, half_axis, radius)
                                   : ball_chord(local, radius);
    if (has_chord(chord)) widen(segment, part, local, chord);
  }
  return segment;
}

// Crossings of a line in order: by depth, entries first, by segment.
bool is_within(int solid, dvec2 depths, int other, dvec2 others) {
  if (leaves())
    return others.x <= depths.y && (depths.y < others.y || (depths.y == others.y && solid < other));
  return (others.x < depths.x || (others.x == depths.x && other < solid)) && depths.x <= others.y;
}

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
      meets = meets_ray(found);
    } else {
      meets = !meets_ray(found) || !is_within(solid, segment.depths, other, found.depths);
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
  dvec2 chord = ball_chord(ray, radius);
  if (!has_chord(chord)) return false;
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
  dvec3 x = segment.ray.offset + segment.t * segment.ray.direction;
  double along = segment.part == BALL_A ? -1.0lf : 1.0lf;
  dvec3 from_axis = x;
  if (segment.part == CYLINDER) {
    double forwards = dot(x, segment.half_axis) / dot(segment.half_axis, segment.half_axis);
    forwards = clamp(forwards, -1.0lf, 1.0lf);
    from_axis -= forwards * segment.half_axis;
    along = segment.backwards ? -forwards : forwards;
  }
  set_vertices(int(links_of(vertex_solid).x), float(0.5lf + 0.5lf * along));
  dvec3 normal = from_axis / radius_of(vertex_solid);
  vertex_direction = vec3(normal);
  solid_facing = min(float(abs(dot(normal, segment.ray.direction))), 1.0);
  return set_depth(leaves() ? segment.depths.y : segment.depths.x);
}
#endif
