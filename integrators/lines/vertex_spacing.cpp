// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/vertex_spacing.h"

#include <algorithm>
#include <cmath>

#include "integrators/paths/magnitude.h"

namespace pellucid::integrators {
namespace {

double angle_between(const Vec3& a, const Vec3& b) {
  const Vec3 from = direction_of(a), to = direction_of(b);
  return std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
}

/// The way from t to `end` in what lies between two vertices at most: its chord, or its turns from
/// look to look. Rest has no direction.
double part_of_spacing(const Trajectory& path, double t, double end, const VertexSpacing& spacing) {
  if (spacing.step > 0)
    return glm::distance(path.position_at(t), path.position_at(end)) / spacing.step;
  constexpr int looks = 4;
  constexpr double rounding = 1e-3;  // of the dense output's directions, in turns
  double turn = 0;
  Vec3 before = path.at(t).v;
  for (int i = 1; i <= looks; ++i) {
    const Vec3 here = path.at(i < looks ? t + (end - t) * i / looks : end).v;
    turn += angle_between(before, here);
    before = here;
  }
  return turn / ((1 + rounding) * spacing.turn);
}

/// The velocity at one vertex foretells the next one, but a flow may speed up or bend on the way:
/// shortened until the way is as short, or turns as little, as it should. Where the flow jumps no
/// way is short enough.
double next_time_within(Trajectory& path, double t, double dt, int most_tries,
                        const VertexSpacing& spacing, fields::FieldSampler& sampler) {
  constexpr double rounding = 1e-9, aim = 0.95;
  double end = t + dt;
  for (int i = 0; i < most_tries; ++i) {
    path.reach(end, sampler);
    end = std::min(end, path.time());
    const double part = part_of_spacing(path, t, end, spacing);
    const double chord = glm::distance(path.position_at(t), path.position_at(end));
    if (!(part > 1 + rounding) || chord <= spacing.shortest) break;
    end = t + std::max(0.5, aim / part) * (end - t);
  }
  return end;
}

}  // namespace

double next_vertex_time(Trajectory& path, double t, const VertexSpacing& spacing,
                        fields::FieldSampler& sampler) {
  constexpr int tries = 10, tries_from_rest = 20;
  const FlowPoint here = path.at(t);
  const double speed = magnitude(here.v);
  // From rest nothing tells how fast it will go.
  if (speed == 0)
    return next_time_within(path, t, spacing.longest, tries_from_rest, spacing, sampler);
  const double turning = magnitude(glm::cross(direction_of(here.v), path.acceleration(t))) / speed;
  const double dt = spacing.step > 0 ? spacing.step / speed : spacing.turn / turning;
  return next_time_within(path, t, std::min(dt, spacing.longest), tries, spacing, sampler);
}

}  // namespace pellucid::integrators
