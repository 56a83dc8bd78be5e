// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/round_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

}  // namespace

LocalRay::LocalRay(const SceneRay& ray, const Vec3& origin) : direction(ray.direction) {
  const Vec3 to_origin = origin - ray.start;
  const double t = glm::dot(to_origin, direction);
  offset = t * direction - to_origin;
  nearest_depth = ray.start.z + t * direction.z;
}

std::optional<Chord> ball_chord(const LocalRay& ray, const Vec3& center, double radius) {
  const double nearest = glm::dot(center - ray.offset, ray.direction);
  const double distance = glm::length(ray.at(nearest) - center);
  const double rest = (radius - distance) * (radius + distance);
  if (!(rest > 0)) return std::nullopt;
  const double half = std::sqrt(rest);
  return Chord{nearest - half, nearest + half};
}

std::optional<Chord> capsule_chord(const LocalRay& ray, const Vec3& half, double radius) {
  Chord chord{infinity, -infinity};
  // The capsule is convex, so the chord spans those of its parts.
  for (const auto& part : {ball_chord(ray, -half, radius), cylinder_chord(ray, half, radius),
                           ball_chord(ray, half, radius)})
    if (part) chord = {std::min(chord.begin, part->begin), std::max(chord.end, part->end)};
  if (!(chord.begin < chord.end)) return std::nullopt;
  return chord;
}

}  // namespace pellucid::groundtruth
