// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/round_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "groundtruth/rays/plane_depth.h"

namespace pellucid::groundtruth {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of the cylinder around the axis through the origin, without ends. `across`: the parts of offset
/// and direction perpendicular to the axis.
std::optional<Chord> endless_cylinder_chord(const Vec3& offset_across, const Vec3& direction_across,
                                            double radius) {
  // Below this sine of the angle between ray and axis the difference that gave it is mere rounding.
  constexpr double parallel = 1e-12;
  const double a = glm::dot(direction_across, direction_across);
  if (a < parallel * parallel) {
    if (glm::dot(offset_across, offset_across) >= radius * radius) return std::nullopt;
    return Chord{-infinity, infinity};
  }
  const double nearest = -glm::dot(offset_across, direction_across) / a;
  const Vec3 p = offset_across + nearest * direction_across;
  const double distance = glm::length(p), rest = (radius - distance) * (radius + distance);
  if (!(rest > 0)) return std::nullopt;
  const double half = std::sqrt(rest / a);
  return Chord{nearest - half, nearest + half};
}

/// Of the cone cos β ρ ≤ h, ρ the distance from its axis, where h > 0 (or at both ends, on the
/// other side of its apex, which is cut off): at x(t) = p + t q across the axis h is h0 + h1 t, and
/// the ray is within where
///   A t² + 2 B t + C ≤ 0,  A = cos²β |q|² - h1²,  B = cos²β p · q - h0 h1,  C = cos²β |p|² - h0².
/// With A > 0, less steep than the cone, it is within between the roots, both on one side of the
/// apex; else from one root on, where h grows, or up to it: at A = 0 the other one is infinitely
/// far away. The discriminant is
///   B² - A C = cos²β (|h0 q - h1 p|² - cos²β |p × q|²),
/// and with D = -(B ± √(B² - A C)), the sign that of B, the roots are D / A and C / D, neither of
/// which loses digits where A vanishes. Differences of squares are taken as products.
std::optional<Chord> endless_cone_chord(const Vec3& p, const Vec3& q, double h0, double h1,
                                        double cosine) {
  const double at_p = cosine * glm::length(p), at_q = cosine * glm::length(q);
  const double a = (at_q - std::abs(h1)) * (at_q + std::abs(h1));
  const double b = cosine * cosine * glm::dot(p, q) - h0 * h1;
  const double c = (at_p - h0) * (at_p + h0);
  const double turn = glm::length(h0 * q - h1 * p), past = cosine * glm::length(glm::cross(p, q));
  const double root = cosine * std::sqrt(std::max(0.0, (turn - past) * (turn + past)));
  const double d = -(b + std::copysign(root, b));
  if (a > 0) {
    if (!(root > 0)) return std::nullopt;
    return Chord{std::min(d / a, c / d), std::max(d / a, c / d)};
  }
  if (d == 0 && a == 0) return std::nullopt;
  const double one = d == 0 ? 0 : c / d, other = a == 0 ? one : d / a;
  if (h1 > 0) return Chord{std::max(one, other), infinity};
  return Chord{-infinity, std::min(one, other)};
}

/// Between the planes at `low` and `high` along the axis, where the ray's coordinate is x + t dx.
Chord slab_chord(double x, double dx, double low, double high) {
  if (dx == 0) return low < x && x < high ? Chord{-infinity, infinity} : Chord{0, 0};
  const double t0 = (low - x) / dx, t1 = (high - x) / dx;
  return {std::min(t0, t1), std::max(t0, t1)};
}

/// A Frustum lies between two balls, around which their common tangents run. Around its axis, from
/// ball a to ball b, L long, with s the place along it from the middle and ρ the distance from it,
/// a plane that touches both balls has a normal at the angle β from across, sin β = (ra - rb) / L.
/// It touches a at s = -L/2 + ra sin β, ρ = ra cos β and b at s = L/2 + rb sin β, ρ = rb cos β:
/// between them the mantle is
///   cos β ρ = h(s) = R - sin β s,  R = (ra + rb) / 2.
/// The ball of centre c on the axis and of the radius R - sin β c, linear from ra to rb, touches it
/// at s = c + (R - sin β c) sin β: c = (s - R sin β) / cos² β.
struct Frustum {
  Frustum(const Vec3& half_axis, double radius_a, double radius_b)
      : half(half_axis),
        half_length(glm::length(half)),
        radius_a(radius_a),
        radius_b(radius_b),
        middle((radius_a + radius_b) / 2),
        sine((radius_a - radius_b) / (2 * half_length)) {}

  /// Neither ball holds the other.
  bool is_there() const { return half_length > 0 && std::abs(sine) < 1; }
  double squared_cosine() const { return (1 - sine) * (1 + sine); }
  /// c / (L/2) of what lies on the mantle at x from the middle.
  double along(const Vec3& x) const {
    const double place = glm::dot(x, half) - middle * sine * half_length;
    return std::clamp(place / (squared_cosine() * glm::dot(half, half)), -1.0, 1.0);
  }
  double radius(double along) const { return middle - 0.5 * (radius_a - radius_b) * along; }

  Vec3 half;
  double half_length, radius_a, radius_b, middle, sine;
};

/// Of the mantle and what lies beyond it. `x` and `dx` are of the ray along the axis.
std::optional<Chord> mantle_chord(const LocalRay& ray, const Frustum& frustum, const Vec3& axis,
                                  double x, double dx) {
  const Vec3 p = ray.offset - x * axis, q = ray.direction - dx * axis;
  if (frustum.sine == 0) return endless_cylinder_chord(p, q, frustum.radius_a);
  return endless_cone_chord(p, q, frustum.middle - frustum.sine * x, -frustum.sine * dx,
                            std::sqrt(frustum.squared_cosine()));
}

/// `ray` is seen from the middle.
std::optional<Chord> frustum_chord(const LocalRay& ray, const Frustum& frustum) {
  if (!frustum.is_there()) return std::nullopt;
  const Vec3 axis = frustum.half / frustum.half_length;
  const double x = glm::dot(ray.offset, axis), dx = glm::dot(ray.direction, axis);
  const auto mantle = mantle_chord(ray, frustum, axis, x, dx);
  if (!mantle) return std::nullopt;
  const Chord slab = slab_chord(x, dx, -frustum.half_length + frustum.radius_a * frustum.sine,
                                frustum.half_length + frustum.radius_b * frustum.sine);
  const Chord chord{std::max(mantle->begin, slab.begin), std::min(mantle->end, slab.end)};
  if (!(chord.begin < chord.end)) return std::nullopt;
  return chord;
}

/// `ray` is seen from the ball's centre.
std::optional<Chord> ball_chord(const LocalRay& ray, double radius) {
  const double nearest = -glm::dot(ray.offset, ray.direction);
  const double distance = glm::length(ray.at(nearest));
  const double rest = (radius - distance) * (radius + distance);
  if (!(rest > 0)) return std::nullopt;
  const double half = std::sqrt(rest);
  return Chord{nearest - half, nearest + half};
}

/// Where the ray crosses the frustum between two balls; a comes first in the order of coordinates.
std::optional<SolidEnds> frustum_ends(const SceneRay& ray, const Ball& a, const Ball& b) {
  const Frustum frustum(0.5 * (b.center - a.center), a.radius, b.radius);
  const LocalRay local(ray, a.center + frustum.half);
  const auto chord = frustum_chord(local, frustum);
  if (!chord) return std::nullopt;
  const auto end = [&](double t) {
    const Vec3 x = local.at(t);
    const double along = frustum.along(x), radius = frustum.radius(along);
    // At a tip there is no normal.
    const Vec3 normal = radius > 0 ? (x - along * frustum.half) / radius : Vec3(0);
    return SolidEnd{local.depth(t), along, glm::dot(normal, local.direction)};
  };
  return SolidEnds{end(chord->begin), end(chord->end)};
}

std::optional<SolidEnds> frustum_ends_any_order(const SceneRay& ray, const Ball& a, const Ball& b) {
  if (!in_coordinate_order(b.center, a.center)) return frustum_ends(ray, a, b);
  auto ends = frustum_ends(ray, b, a);
  if (ends) ends->enters.along *= -1, ends->leaves.along *= -1;
  return ends;
}

/// A ball's ends on a cone-sphere, at whose end `along` it lies.
std::optional<SolidEnds> at(double along, std::optional<SolidEnds> ball) {
  if (ball) ball->enters.along = ball->leaves.along = along;
  return ball;
}

}  // namespace

LocalRay::LocalRay(const SceneRay& ray, const Vec3& origin) : direction(ray.direction) {
  const Vec3 to_origin = origin - ray.start;
  const double t = glm::dot(to_origin, direction);
  offset = t * direction - to_origin;
  nearest_depth = ray.start.z + t * direction.z;
}

std::optional<SolidEnds> ball_ends(const SceneRay& ray, const Vec3& center, double radius) {
  const LocalRay local(ray, center);
  const auto chord = ball_chord(local, radius);
  if (!chord) return std::nullopt;
  // At the ends of the chord n · v is half its length over the radius.
  const double cosine = 0.5 * (chord->end - chord->begin) / radius;
  return SolidEnds{{local.depth(chord->begin), 0, -cosine}, {local.depth(chord->end), 0, cosine}};
}

std::optional<SolidEnds> cone_sphere_ends(const SceneRay& ray, const Ball& a, const Ball& b) {
  std::optional<SolidEnds> ends;
  // The cone-sphere is convex, so the chord spans those of its parts.
  for (const auto& part :
       {at(-1, ball_ends(ray, a.center, a.radius)), at(1, ball_ends(ray, b.center, b.radius)),
        frustum_ends_any_order(ray, a, b)}) {
    if (!part) continue;
    if (!ends) ends = part;
    if (part->enters.depth < ends->enters.depth) ends->enters = part->enters;
    if (part->leaves.depth > ends->leaves.depth) ends->leaves = part->leaves;
  }
  return ends;
}

}  // namespace pellucid::groundtruth
