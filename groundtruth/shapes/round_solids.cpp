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

/// Between the planes at ±half along the axis, where the ray's coordinate is x + t dx.
Chord slab_chord(double x, double dx, double half) {
  if (dx == 0) return std::abs(x) < half ? Chord{-infinity, infinity} : Chord{0, 0};
  const double t0 = (-half - x) / dx, t1 = (half - x) / dx;
  return {std::min(t0, t1), std::max(t0, t1)};
}

std::optional<Chord> cylinder_chord(const LocalRay& ray, const Vec3& half, double radius) {
  const double length = glm::length(half);
  if (!(length > 0)) return std::nullopt;
  const Vec3 axis = half / length;
  const double x = glm::dot(ray.offset, axis), dx = glm::dot(ray.direction, axis);
  const auto round =
      endless_cylinder_chord(ray.offset - x * axis, ray.direction - dx * axis, radius);
  if (!round) return std::nullopt;
  const Chord slab = slab_chord(x, dx, length);
  const Chord chord{std::max(round->begin, slab.begin), std::min(round->end, slab.end)};
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

/// Where the ray crosses the cylinder between the balls around a and b; a comes first in the order
/// of coordinates.
std::optional<SolidEnds> cylinder_ends(const SceneRay& ray, const Vec3& a, const Vec3& b,
                                       double radius) {
  const Vec3 half = 0.5 * (b - a);
  const LocalRay local(ray, a + half);
  const auto chord = cylinder_chord(local, half, radius);
  if (!chord) return std::nullopt;
  const auto end = [&](double t) {
    const Vec3 x = local.at(t);
    const double along = std::clamp(glm::dot(x, half) / glm::dot(half, half), -1.0, 1.0);
    const Vec3 normal = (x - along * half) / radius;
    return SolidEnd{local.depth(t), along, glm::dot(normal, local.direction)};
  };
  return SolidEnds{end(chord->begin), end(chord->end)};
}

std::optional<SolidEnds> cylinder_ends_any_order(const SceneRay& ray, const Vec3& a, const Vec3& b,
                                                 double radius) {
  if (!in_coordinate_order(b, a)) return cylinder_ends(ray, a, b, radius);
  auto ends = cylinder_ends(ray, b, a, radius);
  if (ends) ends->enters.along *= -1, ends->leaves.along *= -1;
  return ends;
}

/// A ball's ends on a capsule, at whose end `along` it lies.
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

std::optional<SolidEnds> capsule_ends(const SceneRay& ray, const Vec3& a, const Vec3& b,
                                      double radius) {
  std::optional<SolidEnds> ends;
  // The capsule is convex, so the chord spans those of its parts.
  for (const auto& part : {at(-1, ball_ends(ray, a, radius)), at(1, ball_ends(ray, b, radius)),
                           cylinder_ends_any_order(ray, a, b, radius)}) {
    if (!part) continue;
    if (!ends) ends = part;
    if (part->enters.depth < ends->enters.depth) ends->enters = part->enters;
    if (part->leaves.depth > ends->leaves.depth) ends->leaves = part->leaves;
  }
  return ends;
}

}  // namespace pellucid::groundtruth
