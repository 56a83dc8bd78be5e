// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/plane_depth.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/rays/bounded_number.h"
#include "groundtruth/rays/exact_line.h"

namespace pellucid::groundtruth {
namespace {

using Corners = std::array<Vec3, 3>;

/// Below this cosine of the angle between a plane's normal and the ray the rounding of vertices to
/// view coordinates may move the crossing by more than 2^14 of it.
constexpr double steepness = 0x1p-14;

/// So that what the filter says is the same for every numbering too.
Corners in_order(Corners corners) {
  std::ranges::sort(corners, in_coordinate_order);
  return corners;
}

/// The line meets the plane at t = height / slope.
template <class Number>
struct Meeting {
  Number height, slope;
  Number squared_lengths;  // of normal times direction: slope² over it is the cosine's square
};

template <class Number>
Meeting<Number> meet(const Line<Number>& line, const Corners& corners) {
  const Triple<Number> a = triple<Number>(corners[0]);
  const Triple<Number> normal = cross_product(difference<Number>(corners[1], corners[0]),
                                              difference<Number>(corners[2], corners[0]));
  return {dot_product(normal, difference(a, line.origin)), dot_product(normal, line.direction),
          dot_product(normal, normal) * dot_product(line.direction, line.direction)};
}

bool surely_positive(const Bounded& x) { return x.value > 1.001L * x.error; }
bool surely_positive(const Exact& x) { return sign_of(x) > 0; }

template <class Number>
bool is_steep(const Meeting<Number>& at) {
  return surely_positive(at.slope * at.slope - at.squared_lengths * Number(steepness * steepness));
}

constexpr scene::CameraFrame view_axes{Vec3(0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

double view_depth_of(const PictureRay& ray, const Corners& corners) {
  const auto rounded = meet(line<Bounded>(view_axes, ray, 1), corners);
  if (const auto depth = quotient(rounded.height, rounded.slope)) return *depth;
  const auto exact = meet(line<Exact>(view_axes, ray, 1), corners);
  if (sign_of(exact.slope) != 0) return quotient(exact.height, exact.slope);
  return quotient(Exact(corners[0].z) + Exact(corners[1].z) + Exact(corners[2].z), Exact(3));
}

}  // namespace

double view_plane_depth(const PictureRay& ray, const std::array<Vec3, 3>& corners) {
  return view_depth_of(ray, in_order(corners));
}

double plane_depth(const ViewFrame& frame, const PictureRay& ray, const FlatTriangle& triangle) {
  const Corners world = in_order(triangle.world);
  const double scale = frame.units_per_length();
  const auto rounded = meet(line<Bounded>(frame.camera(), ray, scale), world);
  if (is_steep(rounded))
    if (const auto t = quotient(rounded.height, rounded.slope)) return scale * *t;
  const auto exact = meet(line<Exact>(frame.camera(), ray, scale), world);
  if (sign_of(exact.height) == 0) return 0;
  if (is_steep(exact)) return scale * quotient(exact.height, exact.slope);
  return view_plane_depth(ray, triangle.view);
}

double point_depth(const ViewFrame& frame, const Vec3& x) {
  const auto depth = [&]<class Number>(Number) {
    return dot_product(difference<Number>(x, frame.camera().eye),
                       triple<Number>(frame.camera().forward));
  };
  const auto rounded = quotient(depth(Bounded()), Bounded(1.0));
  return frame.units_per_length() * (rounded ? *rounded : quotient(depth(Exact()), Exact(1)));
}

/// Depth is a.z + u (b.z - a.z) + v (c.z - a.z). u and v err by at most 4 · 2^-20 each
/// (RayPredicate::sharpen), and the scene lies within √3 of its centre: by 2 · 4 · 2^-20 · 2 √3 <
/// 2^-15. Vertices are rounded by less than 8 · 2^-53 m to view coordinates, none further from the
/// eye than m, and so is the ray, which moves a crossing by 2^14 of the sum at most: 2^-35 m. Of
/// two crossings, twice.
DepthDoubt depth_doubt(const PictureRay& ray, double largest) {
  const double m = (1 + largest) * (1 + std::max(std::abs(ray.x), std::abs(ray.y)));
  return {0x1p-14 + 0x1p-34 * m, 0x1p-49 * m};
}

/// With S = Σ e, the normal's product with the ray: u and v err by 4 · bound / S, and vertices
/// that move by r move the crossing by r / cos of the angle to the normal. S itself is computed
/// with an error of a few bounds.
double depth_error(const PictureRay& ray, const DepthDoubt& doubt, double edge_bound,
                   const std::array<Vec3, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3 normal = glm::cross(b - a, c - a);
  const bool perspective = ray.projection == scene::Projection::perspective;
  const Vec3 direction = perspective ? Vec3(ray.x, ray.y, 1) : Vec3(0, 0, 1);
  const double sum = std::abs(glm::dot(normal, direction)) - 4 * edge_bound;
  const double lengths = glm::length(normal) * glm::length(direction);
  const double deep = std::max({a.z, b.z, c.z}) - std::min({a.z, b.z, c.z});
  const double error = (8 * edge_bound * deep + doubt.rounding * lengths) / sum;
  return sum > 0 ? std::min(error + doubt.rounding, doubt.most / 2) : doubt.most / 2;
}

}  // namespace pellucid::groundtruth
