// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ray of a pixel enters or leaves a sphere, or the tube of a line: the formulas of
// groundtruth/shapes/round_solids.cpp, in double as there, so that they lose no digits but those of
// a picture's depths in float. View frame: view units, z the view depth, the eye at 0.
//
// A tube is one solid, what a ball fills that runs along its line. A segment's crossing counts where it lies
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

#ifdef TAPERED
// Of the cone cos ρ <= h0 + h1 t, where that is above 0, or on the other side of the apex, which is
// cut off; the ray is at p + t q across its axis.
dvec2 endless_cone_chord(dvec3 p, dvec3 q, double h0, double h1, double cosine) {
  precise double at_p = cosine * sqrt(dot(p, p));
  precise double at_q = cosine * sqrt(dot(q, q));
  precise double a = (at_q - abs(h1)) * (at_q + abs(h1));
  precise double b = cosine * cosine * dot(p, q) - h0 * h1;
  precise double c = (at_p - h0) * (at_p + h0);
  precise dvec3 turn_of = h0 * q - h1 * p;
  precise dvec3 past_of = cross(p, q);
  precise double turn = sqrt(dot(turn_of, turn_of));
  precise double past = cosine * sqrt(dot(past_of, past_of));
  precise double root = cosine * sqrt(max(0.0lf, (turn - past) * (turn + past)));
  precise double d = b < 0.0lf ? root - b : -(b + root);
  if (d == 0.0lf && a >= 0.0lf) return no_chord;
  precise double one = d == 0.0lf ? 0.0lf : c / d;
  precise double other = a == 0.0lf ? one : d / a;
  if (a > 0.0lf) return root > 0.0lf ? dvec2(min(one, other), max(one, other)) : no_chord;
  return h1 > 0.0lf ? dvec2(max(one, other), ENDLESS) : dvec2(-ENDLESS, min(one, other));
}
#endif

// Between the planes at `low` and `high` along the axis.
dvec2 slab_chord(double x, double dx, double low, double high) {
  if (dx == 0.0lf) return low < x && x < high ? dvec2(-ENDLESS, ENDLESS) : no_chord;
  precise double t0 = (low - x) / dx;
  precise double t1 = (high - x) / dx;
  return dvec2(min(t0, t1), max(t0, t1));
}

// What lies between two balls, around their common tangents; `radii` are the first one's and the
// second one's.
struct Frustum {
  dvec3 half_axis;  // from the first ball's centre
  dvec2 radii;
  double half_length, sine;  // of the angle between axis and tangents
};

Frustum frustum_between(dvec3 half_axis, dvec2 radii) {
  precise double half_length = sqrt(dot(half_axis, half_axis));
#ifdef TAPERED
  precise double sine = (radii.x - radii.y) / (2.0lf * half_length);
#else
  const double sine = 0.0lf;
#endif
  return Frustum(half_axis, radii, half_length, sine);
}

dvec2 frustum_chord(LocalRay ray, Frustum frustum) {
  if (!(frustum.half_length > 0.0lf && abs(frustum.sine) < 1.0lf)) return no_chord;
  precise dvec3 axis = frustum.half_axis / frustum.half_length;
  precise double x = dot(ray.offset, axis);
  precise double dx = dot(ray.direction, axis);
  precise dvec3 offset_across = ray.offset - x * axis;
  precise dvec3 direction_across = ray.direction - dx * axis;
  dvec2 around = endless_cylinder_chord(offset_across, direction_across, frustum.radii.x);
#ifdef TAPERED
  precise double h0 = (frustum.radii.x + frustum.radii.y) / 2.0lf - frustum.sine * x;
  precise double h1 = -frustum.sine * dx;
  precise double cosine = sqrt((1.0lf - frustum.sine) * (1.0lf + frustum.sine));
  if (frustum.sine != 0.0lf)
    around = endless_cone_chord(offset_across, direction_across, h0, h1, cosine);
#endif
  precise dvec2 touched = frustum.sine * frustum.radii;
  precise double low = -frustum.half_length + touched.x;
  precise double high = frustum.half_length + touched.y;
  dvec2 along = slab_chord(x, dx, low, high);
  dvec2 chord = dvec2(max(around.x, along.x), min(around.y, along.y));
  return has_chord(chord) ? chord : no_chord;
}

// Where the ball's centre lies, from -1 to 1, that touches a frustum's mantle at x from its middle.
double along_of(Frustum frustum, dvec3 x) {
  double shift = 0.5lf * (frustum.radii.x + frustum.radii.y) * frustum.sine * frustum.half_length;
  double squared = dot(frustum.half_axis, frustum.half_axis);
  double squared_cosine = (1.0lf - frustum.sine) * (1.0lf + frustum.sine);
  return clamp((dot(x, frustum.half_axis) - shift) / (squared_cosine * squared), -1.0lf, 1.0lf);
}

double radius_along(dvec2 radii, double along) {
  return 0.5lf * (radii.x + radii.y) - 0.5lf * (radii.x - radii.y) * along;
}

const int BALL_A = 0, BALL_B = 1, FRUSTUM = 2;

dvec2 radii_of(int solid) {
  double radius = radius_of(solid);
#ifdef TAPERED
  int second = int(links_of(solid).w);
  uvec2 words = uvec2(texelFetch(solid_overlaps, second).r, texelFetch(solid_overlaps, second + 1).r);
  return dvec2(radius, packDouble2x32(words));
#else
  return dvec2(radius);
#endif
}

// A segment as the ray meets it.
struct Segment {
  dvec2 depths;     // where the ray enters and leaves; no_chord if it does not meet it
  Frustum frustum;  // from the end that comes first in the order of coordinates
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

// A segment is convex: its chord spans those of its parts. Each end is computed from the centre of
// its part: segments that share a ball, or a frustum from either side, have the same bits.
Segment cast_at(int solid, Ray ray) {
  int first = int(links_of(solid).x);
  dvec2 radii = radii_of(solid);
  dvec3 a = load_point(first).position, b = load_point(first + 1).position;
  bool backwards = in_coordinate_order(b, a);
  precise dvec3 half_axis = 0.5lf * (backwards ? a - b : b - a);
  precise dvec3 middle = (backwards ? b : a) + half_axis;
  LocalRay local = local_ray(ray, a);
  Frustum frustum = frustum_between(half_axis, backwards ? radii.yx : radii);
  Segment segment = Segment(no_chord, frustum, backwards, BALL_A, local, 0.0lf);
  for (int part = BALL_A; part <= FRUSTUM; ++part) {
    if (part != BALL_A) local = local_ray(ray, part == BALL_B ? b : middle);
    dvec2 chord = part == FRUSTUM ? frustum_chord(local, frustum)
                                  : ball_chord(local, part == BALL_A ? radii.x : radii.y);
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
  vertex_importance = interpolated_importance(from.importance);
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
  vertex_importance = mix(interpolated_importance(a.importance),
                          interpolated_importance(b.importance), along);
  vertex_opacity = mix(a.opacity, b.opacity, along);
}

// Returns whether there is a fragment.
bool meet_solid() {
  Ray ray = pixel_ray_of_target();
  Segment segment;
  if (!meet_line(vertex_solid, ray, segment)) return false;
  dvec3 x = segment.ray.offset + segment.t * segment.ray.direction;
  double forwards = (segment.part == BALL_A) == segment.backwards ? 1.0lf : -1.0lf;
  dvec3 from_axis = x;
  if (segment.part == FRUSTUM) {
    forwards = along_of(segment.frustum, x);
    from_axis -= forwards * segment.frustum.half_axis;
  }
  double along = segment.backwards ? -forwards : forwards;
  set_vertices(int(links_of(vertex_solid).x), float(0.5lf + 0.5lf * along));
  double radius = radius_along(segment.frustum.radii, forwards);
  dvec3 normal = radius > 0.0lf ? from_axis / radius : dvec3(0.0lf);  // none at a tip
  vertex_direction = vec3(normal);
  solid_facing = min(float(abs(dot(normal, segment.ray.direction))), 1.0);
  return set_depth(leaves() ? segment.depths.y : segment.depths.x);
}
#endif
