// SPDX-License-Identifier: GPL-3.0-or-later
// A tube is one solid, what a ball fills that runs along its line. A segment's crossing counts where
// it lies in none of the segments of the same line that overlap this one: the sum over chords of
// groundtruth/traversal/solid_union.cpp, read for one chord. After solid.glsl.
#include "oit/shapes/frustum.glsl"

layout(binding = solid_overlaps_texture) uniform usamplerBuffer solid_overlaps;

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

void set_vertices(int first, float along) {
  SolidPoint a = load_point(first), b = load_point(first + 1);
  vertex_color = mix(load_color(first), load_color(first + 1), along);
  vertex_importance = mix(interpolated_importance(a.importance),
                          interpolated_importance(b.importance), along);
  vertex_opacity = mix(a.opacity, b.opacity, along);
}

// Returns whether there is a fragment.
bool meet() {
  Ray ray = pixel_ray_of_target();
  Segment segment;
  if (!meet_line(vertex_record, ray, segment)) return false;
  dvec3 x = segment.ray.offset + segment.t * segment.ray.direction;
  double forwards = (segment.part == BALL_A) == segment.backwards ? 1.0lf : -1.0lf;
  dvec3 from_axis = x;
  if (segment.part == FRUSTUM) {
    forwards = along_of(segment.frustum, x);
    from_axis -= forwards * segment.frustum.half_axis;
  }
  double along = segment.backwards ? -forwards : forwards;
  set_vertices(int(links_of(vertex_record).x), float(0.5lf + 0.5lf * along));
  double radius = radius_along(segment.frustum.radii, forwards);
  dvec3 normal = radius > 0.0lf ? from_axis / radius : dvec3(0.0lf);  // none at a tip
  vertex_direction = vec3(normal);
  cast_facing = min(float(abs(dot(normal, segment.ray.direction))), 1.0);
  return set_depth(leaves() ? segment.depths.y : segment.depths.x);
}
