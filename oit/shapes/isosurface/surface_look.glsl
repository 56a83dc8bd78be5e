// SPDX-License-Identifier: GPL-3.0-or-later
// Colour, opacity and hole of an isosurface: see SurfaceLook in surface_look.h, which has the same
// numbers in the same order. After isosurface.glsl's number().
const int LOOK_COLOR = 0, LOOK_OPACITY = 3, LOOK_STOPS = 4, LOOK_STOP_COUNT = 5,
          LOOK_COLOR_SCALE = 6, LOOK_NAN = 10, LOOK_FADING_SCALE = 13, LOOK_OPACITIES = 17,
          LOOK_HOLE = 19, LOOK_HOLE_RADIUS = 22;
const double SCALE_NONE = 0.0lf, SCALE_LINEAR = 1.0lf, SCALE_LOGARITHMIC = 2.0lf;
const double FAR_BEYOND = 1e30lf;  // the range

bool is_colored(int surface) { return number(surface + LOOK_COLOR_SCALE) != SCALE_NONE; }
bool is_faded(int surface) { return number(surface + LOOK_FADING_SCALE) != SCALE_NONE; }

// The logarithm of a number above 0, to a float, of any size that a double has.
double logarithm(double x) {
  uvec2 bits = unpackDouble2x32(x);
  int exponent = int(bits.y >> 20u) - 1023;
  double mantissa = packDouble2x32(uvec2(bits.x, (bits.y & 0xfffffu) | 0x3ff00000u));  // 1 … 2
  return double(log(float(mantissa))) + double(exponent) * 0.693147180559945309lf;
}

// Of a scale's range; see scene::fraction_of(). `scalar` is as it is kept.
double fraction_of(int scale, double scalar) {
  double kind = number(scale), at = number(scale + 1) * scalar + number(scale + 2);
  double length = number(scale + 3);  // of the range
  if (kind == SCALE_LINEAR) return at;
  if (kind == SCALE_LOGARITHMIC)  // `at` is over the range's first end
    return at > 0.0lf ? logarithm(at) / length : -sign(length) * FAR_BEYOND;
  return at == 0.0lf ? 0.0lf : sign(at) * FAR_BEYOND;  // a range of no width
}

vec3 color_of(int surface, double scalar) {
  if (!is_colored(surface)) return vec3(vector(surface + LOOK_COLOR));
  double x = fraction_of(surface + LOOK_COLOR_SCALE, scalar);
  if (isnan(x)) return vec3(vector(surface + LOOK_NAN));
  x = clamp(x, 0.0lf, 1.0lf);
  int stops = int(number(surface + LOOK_STOPS));  // four numbers each: place, colour
  int low = 0, high = int(number(surface + LOOK_STOP_COUNT)) - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (number(stops + 4 * middle) <= x)
      low = middle;
    else
      high = middle;
  }
  double from = number(stops + 4 * low), to = number(stops + 4 * high);
  return vec3(mix(vector(stops + 4 * low + 1), vector(stops + 4 * high + 1),
                  (x - from) / (to - from)));
}

float opacity_of(int surface, double scalar) {
  if (!is_faded(surface)) return float(number(surface + LOOK_OPACITY));
  double x = clamp(fraction_of(surface + LOOK_FADING_SCALE, scalar), 0.0lf, 1.0lf);
  return float(mix(number(surface + LOOK_OPACITIES), number(surface + LOOK_OPACITIES + 1), x));
}

// World axes, from the eye.
bool is_cut_away(int surface, dvec3 x) {
  double radius = number(surface + LOOK_HOLE_RADIUS);
  return radius > 0.0lf && length((x - vector(surface + LOOK_HOLE)) / radius) < 1.0lf;
}
