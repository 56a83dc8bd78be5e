// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ray is in what lies between the balls of a segment's ends. After solid.glsl; with the define
// TAPERED their radii may differ.

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
