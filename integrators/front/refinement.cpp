// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/refinement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "integrators/paths/trajectory_options.h"

namespace pellucid::integrators {
namespace {

// Vertex normals across an edge differ by at most so much, unless the edge is very short. Between
// them the surface would turn unseen: rolled up thinner than the threshold, it would be cut across.
constexpr double coarse_cosine = 0.866;  // 30°
constexpr double fine_cosine = 0.978;    // 12°
double cosine(const FrontPoint& a, const FrontPoint& b) {
  if (a.normal == Vec3(0) || b.normal == Vec3(0)) return 1;
  return glm::dot(a.normal, b.normal);
}

/// Time until the particle has moved by `move` at its present speed.
double time_to_move(const FrontPoint& here, double move) {
  return std::min(move / here.speed, std::numeric_limits<double>::max());
}

/// The longest time whose chord's sagitta is allowed, by the present curvature. What sets off from
/// rest goes along its acceleration, straight at first.
double time_to_bend(const FrontPoint& here, const Vec3& acceleration, double sagitta) {
  if (here.speed == 0) return std::numeric_limits<double>::max();
  const Vec3 across = acceleration - glm::dot(acceleration, here.direction) * here.direction;
  return std::sqrt(8 * sagitta / glm::length(across));
}

/// How fast the ribbon towards a neighbour twists out of its plane: over a time dt the middle of
/// its diagonal leaves the surface by dt / 4 of this.
double twist_rate(const FrontPoint& here, const FrontPoint& neighbour) {
  const Vec3 apart = neighbour.flow.v - here.flow.v;
  return std::max(std::abs(glm::dot(apart, here.normal)),
                  std::abs(glm::dot(apart, neighbour.normal)));
}

// Triangles are at most so many times longer than wide, or wider than long, by choice.
constexpr double longest_aspect = 8;
constexpr double widest_aspect = 3;

/// The shortest time that a ribbon's triangles should take, so as not to be too wide.
double shortest_time(const FrontPoint& a, const FrontPoint& b) {
  const double speed = 0.5 * (a.speed + b.speed);
  if (speed == 0) return std::numeric_limits<double>::max();
  return separation(a, b).width / (widest_aspect * speed);
}

/// How far the middle of the ribbon's diagonal strays from the surface in the shortest time.
double twist_sagitta(const FrontPoint& a, const FrontPoint& b) {
  const double rate = twist_rate(a, b);
  return rate > 0 ? 0.25 * shortest_time(a, b) * rate : 0;
}

// A trajectory that bends between two vertices by a large part of its ribbon's width tilts the
// ribbon's triangles by that part, as in Schwarz's lantern.
constexpr double largest_tilt = 0.15;

/// The shortest step that is one, time units: over less of it a particle has not left its place,
/// or doubles do not tell the times apart, and a front would go on for ever without a triangle.
double shortest_step(const Trajectory& path, const FrontPoint& head) {
  constexpr double resolution = 4 * std::numeric_limits<double>::epsilon();
  const double to_move = head.speed > 0 ? 2 * path.still() / head.speed : 0;
  return std::min(std::max(to_move, resolution * head.t), path.longest_plan());
}

/// By how much the step to `next` has to be shortened: 1 when it will do.
double shortening(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                  const FrontPoint* left, const FrontPoint* right, const FrontPoint& next) {
  const double moved = glm::distance(next.flow.x, head.flow.x);
  const bool is_short = moved <= shortest_edge(refinement);
  if (cosine(head, next) < coarse_cosine && !is_short) return 0.5;
  if (refinement.step > 0 && moved > 1.25 * refinement.step) return refinement.step / moved;
  const double sagitta = path.sagitta(head.t, next.t);
  double largest = refinement.by_tolerance() ? refinement.largest_step_sagitta() : refinement.step;
  for (const FrontPoint* neighbour : {left, right})
    if (neighbour && !is_short)
      largest = std::min(largest, largest_tilt * separation(head, *neighbour).width);
  if (sagitta <= largest) return 1;
  return std::clamp(0.9 * std::sqrt(largest / sagitta), 0.3, 0.8);
}

}  // namespace

namespace {

/// What the refinement asks for, however short.
double wanted_step(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                   const FrontPoint* left, const FrontPoint* right) {
  double longest = path.longest_plan();
  if (refinement.step > 0) longest = std::min(longest, time_to_move(head, refinement.step));
  if (!refinement.by_tolerance()) return longest;
  const double sagitta = refinement.largest_step_sagitta();
  // A ribbon that has become as thin as the tolerance has no shape to keep.
  const double thin = 8 * refinement.tolerance;
  double dt = time_to_bend(head, path.acceleration(head.t), sagitta);
  for (const FrontPoint* neighbour : {left, right}) {
    if (!neighbour) continue;
    const double width = separation(head, *neighbour).width;
    const double twist = 4 * refinement.largest_sagitta() / twist_rate(head, *neighbour);
    dt = std::min({dt, std::max(twist, shortest_time(head, *neighbour)),
                   time_to_move(head, longest_aspect * std::max(width, thin))});
  }
  return std::min(dt, longest);
}

}  // namespace

double planned_step(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                    const FrontPoint* left, const FrontPoint* right) {
  return std::max(wanted_step(refinement, path, head, left, right), shortest_step(path, head));
}

double allowed_step(const Refinement& refinement, const Trajectory& path, const FrontPoint& head,
                    const FrontPoint* left, const FrontPoint* right, const FrontPoint& next) {
  const double moved = next.t - head.t;
  if (!(moved > 0)) return std::numeric_limits<double>::infinity();
  const double part = shortening(refinement, path, head, left, right, next);
  const double shortest = shortest_step(path, head);
  if (part >= 1 || moved <= shortest) return std::numeric_limits<double>::infinity();
  return std::max(std::max(part, 0.1) * moved, shortest);
}

double shortest_edge(const Refinement& refinement) {
  constexpr double part_of_threshold = 1. / 32;
  return refinement.by_tolerance() ? refinement.tolerance
                                   : part_of_threshold * refinement.threshold;
}

OptionTable<RefinementOptions> refinement_options(double default_threshold) {
  using Options = RefinementOptions;
  return {
      number("threshold", &Options::threshold,
             {.min = 0,
              .unit = "world units",
              .help = fmt::format("a ribbon wider than this gets a particle; default {}, unless a "
                                  "tolerance is given",
                                  default_threshold)}),
      number("tolerance", &Options::tolerance,
             {.min = 0,
              .unit = "world units",
              .help = "largest distance of mesh and surface, instead of a threshold"}),
      number("step", &Options::step,
             {.min = 0,
              .unit = "world units",
              .help = "longest way between a particle's vertices; default: by threshold; beside a "
                      "tolerance it adds to what that asks for"}),
      number("facet-angle", &Options::facet_angle,
             {.min = 1,
              .max = 180,
              .unit = "degrees",
              .help = "facets farther from the normals at their corners are mended; 180: none"})};
}

Refinement refinement_of(const RefinementOptions& options, double default_threshold,
                         double steps_per_threshold) {
  Refinement refinement;
  refinement.tolerance = positive("tolerance", options.tolerance, 0);
  if (refinement.by_tolerance() && options.threshold)
    throw InputError("threshold and tolerance are both given; accepted: one of them");
  if (!refinement.by_tolerance()) {
    refinement.threshold = positive("threshold", options.threshold, default_threshold);
    refinement.step = refinement.threshold / steps_per_threshold;
  }
  refinement.step = positive("step", options.step, refinement.step);
  return refinement;
}

namespace {

/// Of two that have no time in common: what their edge alone tells.
bool asks_for_more_by_edge(const Refinement& refinement, double length, double sagitta) {
  if (!refinement.by_tolerance()) return length > 2 * refinement.threshold;
  return sagitta > refinement.largest_sagitta();
}

}  // namespace

bool asks_for_more(const Refinement& refinement, const Abreast& two, double sagitta) {
  const auto& [a, b, comparable] = two;
  const auto [distance, width] = separation(a, b);
  const double shortest = shortest_edge(refinement);
  if (!comparable) return asks_for_more_by_edge(refinement, distance, sagitta);
  if (are_parting(a, b) && distance > shortest) return true;
  if (cosine(a, b) < coarse_cosine && distance > shortest) return true;
  if (!refinement.by_tolerance())
    return width > refinement.threshold || distance > 2 * refinement.threshold;
  if (twist_sagitta(a, b) > refinement.largest_sagitta() && distance > shortest) return true;
  return sagitta > refinement.largest_sagitta();
}

bool can_do_without(const Refinement& refinement, const Abreast& two, double sagitta) {
  const auto& [a, b, comparable] = two;
  if (!comparable || are_parting(a, b) || cosine(a, b) < fine_cosine) return false;
  const auto [distance, width] = separation(a, b);
  if (!refinement.by_tolerance())
    return width <= 0.5 * refinement.threshold && distance <= refinement.threshold;
  // Twice as long an edge has four times the sagitta.
  return std::max(sagitta, twist_sagitta(a, b)) < refinement.largest_sagitta() / 4;
}

namespace {

struct TriangleShape {
  double facing;         // cosine between its normal and that of the corner where it differs most
  double smallest_sine;  // of its angles
};

TriangleShape shape_of(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  const Vec3 ab = b.flow.x - a.flow.x, bc = c.flow.x - b.flow.x, ca = a.flow.x - c.flow.x;
  const Vec3 area = glm::cross(ab, bc);
  const double twice_area = glm::length(area);
  if (!(twice_area > 0)) return {1, 0};
  TriangleShape shape{1, 0};
  for (const FrontPoint* corner : {&a, &b, &c})
    if (corner->normal != Vec3(0))
      shape.facing = std::min(shape.facing, glm::dot(area, corner->normal) / twice_area);
  // Twice the area over the product of the two longest sides.
  const double l0 = glm::length(ab), l1 = glm::length(bc), l2 = glm::length(ca);
  shape.smallest_sine = twice_area * std::min({l0, l1, l2}) / (l0 * l1 * l2);
  return shape;
}

}  // namespace

bool is_well_shaped(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  const auto [facing, smallest_sine] = shape_of(a, b, c);
  return smallest_sine > 0.1 && facing >= coarse_cosine;
}

double well_shapedness(const FrontPoint& a, const FrontPoint& b, const FrontPoint& c) {
  const auto [facing, smallest_sine] = shape_of(a, b, c);
  return std::min(facing, coarse_cosine) + smallest_sine;
}

namespace {

/// How long the particle may go, and where it then is: at most at the end of its path.
struct AllowedStep {
  double dt;
  FrontPoint next;
};

AllowedStep step_of(const Refinement& refinement, Trajectory& path, const FrontPoint& head,
                    const FrontPoint* left, const FrontPoint* right,
                    fields::FieldSampler& sampler) {
  constexpr int most_attempts = 12;
  AllowedStep step{planned_step(refinement, path, head, left, right), {}};
  for (int attempt = 0;; ++attempt) {
    path.reach(head.t + step.dt, sampler);
    step.next = front_point(path, std::min(head.t + step.dt, path.time()));
    const double allowed = allowed_step(refinement, path, head, left, right, step.next);
    if (std::isinf(allowed) || attempt == most_attempts) return step;
    step.dt = allowed;
  }
}

}  // namespace

std::optional<FrontPoint> next_vertex(const Refinement& refinement, Trajectory& path,
                                      const FrontPoint& head, const FrontPoint* left,
                                      const FrontPoint* right, fields::FieldSampler& sampler) {
  const auto [dt, next] = step_of(refinement, path, head, left, right, sampler);
  // Half a step further tells whether a sliver would be left at the end.
  if (path.reach(head.t + 1.5 * dt, sampler)) return next;
  const double left_over = path.time() - head.t;
  if (left_over <= 1e-6 * dt || left_over <= 0) return std::nullopt;
  if (left_over > dt && left_over < 1.5 * dt) return front_point(path, head.t + 0.5 * left_over);
  return next;
}

}  // namespace pellucid::integrators
