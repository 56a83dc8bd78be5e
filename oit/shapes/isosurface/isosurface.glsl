// SPDX-License-Identifier: GPL-3.0-or-later
// Where the ray of a pixel crosses an isosurface within a piece (see fields/levels/surface_pieces.h):
// the reconstruction along the ray is a polynomial there, whose sign changes are found as
// groundtruth/levels/level_ray.h says. World axes, from the eye; in double. After cast.glsl.
#ifdef ISOSURFACE
#define MOST_DEGREE 1
#else
#define MOST_DEGREE FADING_DEGREE
#endif
#include "oit/shapes/isosurface/piece_record.glsl"
#include "oit/shapes/isosurface/ray_roots.glsl"

// Doubles: the axes of the view frame in world axes, a view unit long; then what surfaces have; then
// the pieces' polynomials.
layout(binding = isosurface_numbers_texture) uniform usamplerBuffer isosurface_numbers;

double number(int i) { return packDouble2x32(texelFetch(isosurface_numbers, i).xy); }
dvec3 vector(int i) { return dvec3(number(i), number(i + 1), number(i + 2)); }

#include "oit/shapes/isosurface/surface_look.glsl"

struct Piece {
  dvec3 low, high;
  int numbers, surface, degree, crossing, jump_axis;  // -1: it is no face
  bool weighted;
};

Piece load_piece(int i) {
  int at = PIECE_TEXELS * i;
  uvec4 a = texelFetch(isosurface_pieces, at + 1), b = texelFetch(isosurface_pieces, at + 2),
        c = texelFetch(isosurface_pieces, at + 3), d = texelFetch(isosurface_pieces, at + 4);
#if MOST_DEGREE == 1
  const int degree = 1;
#else
  int degree = int(d.z & 0xffu);
#endif
  return Piece(dvec3(packDouble2x32(a.xy), packDouble2x32(a.zw), packDouble2x32(b.xy)),
               dvec3(packDouble2x32(b.zw), packDouble2x32(c.xy), packDouble2x32(c.zw)), int(d.x),
               int(d.y), degree, int(d.w >> 1u), int(d.z >> 8u) - 1, (d.w & PIECE_WEIGHTED) != 0u);
}

int numbers_of_polynomial(Piece piece) {
  int n = piece.degree + 1;
  return n * n * n;
}

dvec3 in_world_axes(dvec3 view) {
  return view.x * vector(0) + view.y * vector(3) + view.z * vector(6);
}

// From where to where, its ends in the box: planes are met at parameters that every piece beside them
// computes in the same way, and an end on a plane is exactly there.
struct Stretch {
  double begin, end;  // the ray's parameter
  dvec3 from, to;     // in [0, 1] within the box
};

double place_in(double x, double low, double high) {
  precise double place = (x - low) / (high - low);
  return clamp(place, 0.0lf, 1.0lf);
}

// Begins and ends where the ray meets the box; a plane belongs to the piece that the ray enters there,
// or that lies above it. In a face it does both at once.
bool stretch_in(Piece piece, Ray ray, out Stretch s) {
  dvec3 first, last;  // where the ray meets the lower and the upper planes
  s.begin = 0.0lf;
  s.end = ENDLESS;
  for (int axis = 0; axis < 3; ++axis) {
    double start = ray.start[axis], direction = ray.direction[axis];
    if (direction == 0.0lf) {
      if (!(piece.low[axis] <= start && start < piece.high[axis])) return false;
      first[axis] = last[axis] = -1.0lf;  // never
      continue;
    }
    precise double a = (piece.low[axis] - start) / direction;
    precise double b = (piece.high[axis] - start) / direction;
    first[axis] = a;
    last[axis] = b;
    if (axis == piece.jump_axis) continue;
    s.begin = max(s.begin, min(a, b));
    s.end = min(s.end, max(a, b));
  }
  if (!(s.begin < s.end)) return false;
  if (piece.jump_axis >= 0) {
    double t = first[piece.jump_axis];
    if (!(s.begin <= t && t < s.end)) return false;
    s.begin = s.end = t;
  }
  for (int axis = 0; axis < 3; ++axis) {
    precise double x = ray.start[axis] + s.begin * ray.direction[axis];
    precise double y = ray.start[axis] + s.end * ray.direction[axis];
    s.from[axis] = s.begin == first[axis]  ? 0.0lf
                   : s.begin == last[axis] ? 1.0lf
                                           : place_in(x, piece.low[axis], piece.high[axis]);
    s.to[axis] = s.end == first[axis]  ? 0.0lf
                 : s.end == last[axis] ? 1.0lf
                                       : place_in(y, piece.low[axis], piece.high[axis]);
  }
  return true;
}

const int ROW = MOST_DEGREE + 1;

double binomial(int n, int k) {
  double value = 1.0lf;
  for (int i = 1; i <= k; ++i) value = value * double(n - k + i) / double(i);
  return value;
}

// What Bernstein's coefficients along an axis count in the polar form with i arguments `to` and n - i
// arguments `from`: those of Π ((1 - t) + t z) in z. Row i has n + 1 of them.
void polar_weights(int n, double from, double to, out double weights[ROW * ROW]) {
  for (int i = 0; i <= n; ++i) {
    for (int l = 0; l <= n; ++l) weights[i * ROW + l] = l == 0 ? 1.0lf : 0.0lf;
    for (int factor = 0; factor < n; ++factor) {
      double t = factor < i ? to : from;
      for (int l = factor + 1; l >= 0; --l) {
        precise double lower = l > 0 ? t * weights[i * ROW + l - 1] : 0.0lf;
        precise double w = (1.0lf - t) * weights[i * ROW + l] + lower;
        weights[i * ROW + l] = w;
      }
    }
  }
}

// The polynomial along a stretch, by its polar form (Ramshaw 1989): b[m] is the mean of those with m
// arguments `to` among the 3 n of the three axes.
void polynomial_along(Piece piece, Stretch s, int first, out double b[MOST_ROOTS + 1]) {
  int n = piece.degree;
  double x[ROW * ROW], y[ROW * ROW], z[ROW * ROW];
  polar_weights(n, s.from.x, s.to.x, x);
  polar_weights(n, s.from.y, s.to.y, y);
  polar_weights(n, s.from.z, s.to.z, z);
  for (int m = 0; m <= 3 * n; ++m) b[m] = 0.0lf;
  for (int i = 0; i <= n; ++i) {
    double plane[ROW * ROW];  // the coefficients in y and z, x done
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j) {
        precise double sum = 0.0lf;
        for (int l = 0; l <= n; ++l)
          sum += x[i * ROW + l] * number(first + l + (n + 1) * (j + (n + 1) * k));
        plane[j + ROW * k] = sum;
      }
    for (int j = 0; j <= n; ++j) {
      double line[ROW];
      for (int k = 0; k <= n; ++k) {
        precise double sum = 0.0lf;
        for (int l = 0; l <= n; ++l) sum += y[j * ROW + l] * plane[l + ROW * k];
        line[k] = sum;
      }
      for (int k = 0; k <= n; ++k) {
        precise double sum = 0.0lf;
        for (int l = 0; l <= n; ++l) sum += z[k * ROW + l] * line[l];
#if MOST_DEGREE == 1
        precise double term = sum;
#else
        precise double term = binomial(n, i) * binomial(n, j) * binomial(n, k) * sum;
#endif
        b[i + j + k] += term;
      }
    }
  }
  for (int m = 1; m < 3 * n; ++m) b[m] /= binomial(3 * n, m);
}

// Bernstein's polynomials of degree n at t, and their derivatives.
void bernstein(int n, double t, out double values[ROW], out double slopes[ROW]) {
  values[0] = 1.0lf;
  slopes[0] = 0.0lf;
  for (int degree = 1; degree <= n; ++degree) {
    values[degree] = slopes[degree] = 0.0lf;
    for (int l = degree; l >= 0; --l) {
      double below = l > 0 ? values[l - 1] : 0.0lf;
      slopes[l] = double(degree) * (below - (l < degree ? values[l] : 0.0lf));
      values[l] = (1.0lf - t) * values[l] + t * below;
    }
  }
}

// A polynomial's value at a place in the box, and its derivatives per unit of the world.
dvec4 polynomial_at(Piece piece, dvec3 place, int first) {
  int n = piece.degree;
  double x[ROW], y[ROW], z[ROW], dx[ROW], dy[ROW], dz[ROW];
  bernstein(n, place.x, x, dx);
  bernstein(n, place.y, y, dy);
  bernstein(n, place.z, z, dz);
  dvec4 sum = dvec4(0.0lf);
  for (int k = 0; k <= n; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        sum += number(first + i + (n + 1) * (j + (n + 1) * k)) *
               dvec4(x[i] * y[j] * z[k], dx[i] * y[j] * z[k], x[i] * dy[j] * z[k],
                     x[i] * y[j] * dz[k]);
  return sum / dvec4(1.0lf, piece.high - piece.low);
}

// Where no hat reaches an end of a stretch, Σ w (f - value) is 0 there as well, and has the sign that it
// has next to it. Elsewhere a 0 is the surface.
void leave_zeros(Piece piece, Stretch s, inout double b[MOST_ROOTS + 1]) {
  const double least_weight = 1e-10lf;  // of rounding alone
  int n = 3 * piece.degree, weights = piece.numbers + numbers_of_polynomial(piece);
  double largest = 0.0lf;
  for (int i = 0; i <= n; ++i) largest = max(largest, abs(b[i]));
  double least = 1e-10lf * largest;
  if (abs(b[0]) <= least && polynomial_at(piece, s.from, weights).x <= least_weight)
    for (int i = 1; i <= n; ++i)
      if (abs(b[i]) > least) {
        b[0] = b[i] < 0.0lf ? -least : least;
        break;
      }
  if (abs(b[n]) <= least && polynomial_at(piece, s.to, weights).x <= least_weight)
    for (int i = n - 1; i >= 0; --i)
      if (abs(b[i]) > least) {
        b[n] = b[i] < 0.0lf ? -least : least;
        break;
      }
}

#ifdef LIT
// In world axes; the direction has a length of 1.
void set_normal(Piece piece, dvec3 place, dvec3 direction) {
  dvec3 gradient = polynomial_at(piece, place, piece.numbers).yzw;
  double size = length(gradient);
  dvec3 normal = size > 0.0lf ? gradient / size : direction;
  dvec3 axes = dvec3(dot(vector(0), normal), dot(vector(3), normal), dot(vector(6), normal));
  vertex_direction = vec3(axes / length(axes));
  cast_facing = float(abs(dot(normal, direction)));
}
#endif

void set_look(Piece piece, dvec3 place) {
  int count = numbers_of_polynomial(piece), next = piece.numbers + count;
  double weight = 1.0lf;
  if (piece.weighted) {
    weight = polynomial_at(piece, place, next).x;
    next += count;
  }
  dvec2 scalars = dvec2(0.0lf);  // that colours, and that fades
  if (is_colored(piece.surface)) {
    scalars.x = polynomial_at(piece, place, next).x / weight;
    next += count;
  }
  if (is_faded(piece.surface)) scalars.y = polynomial_at(piece, place, next).x / weight;
  vertex_color = vec4(color_of(piece.surface, scalars.x), opacity_of(piece.surface, scalars.y));
}

int count_of_polynomials(Piece piece) {
  return 1 + int(piece.weighted) + int(is_colored(piece.surface)) + int(is_faded(piece.surface));
}

// On a face: whether its sides lie on both sides of the value.
bool jumps(Piece piece, dvec3 place) {
  int other_side = piece.numbers + count_of_polynomials(piece) * numbers_of_polynomial(piece);
  return signs_differ(polynomial_at(piece, place, piece.numbers).x,
                      polynomial_at(piece, place, other_side).x);
}

// Returns whether there is a fragment.
bool meet() {
  Piece piece = load_piece(vertex_record);
  Ray seen = pixel_ray_of_target();
  Ray ray = Ray(in_world_axes(seen.start), in_world_axes(seen.direction));
  Stretch s;
  if (!stretch_in(piece, ray, s)) return false;
  double root = 0.0lf;
  if (piece.jump_axis >= 0) {
    if (!jumps(piece, s.from)) return false;
  } else {
    double b[MOST_ROOTS + 1];
    polynomial_along(piece, s, piece.numbers, b);
    if (piece.weighted) leave_zeros(piece, s, b);
    root = sign_change(b, 3 * piece.degree, piece.crossing);
    if (root < 0.0lf) return false;
  }
  precise double t = s.begin + root * (s.end - s.begin);
  if (is_cut_away(piece.surface, ray.start + t * ray.direction)) return false;
  dvec3 place = mix(s.from, s.to, root);
  set_look(piece, place);
#ifdef LIT
  set_normal(piece, place, normalize(ray.direction));
#endif
  vertex_importance = interpolated_importance(0.0);
  vertex_opacity = 1.0;
  precise double depth = seen.start.z + t * seen.direction.z;
  return set_depth(depth);
}
