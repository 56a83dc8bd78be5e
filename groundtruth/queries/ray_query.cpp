// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/queries/ray_query.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "geometry/files/mesh_formats.h"

namespace pellucid::groundtruth {
namespace {

constexpr std::uint32_t leaf_size = 4;

void check(const FreeRay& ray) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(ray.origin[axis]) < geometry::coordinate_limit) ||
        !(std::abs(ray.direction[axis]) < geometry::coordinate_limit))
      throw InputError("ray: a number that is not finite; accepted: finite numbers below 1e300");
  if (ray.direction == Vec3(0))
    throw InputError("ray: the direction is 0; accepted: any other length");
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the ray enters the box at the earliest, if it may meet it. Distances carry a rounding for
/// their difference and one for their quotient; they are moved apart by more.
std::optional<double> earliest(const FreeRay& ray, const Box3& box) {
  constexpr double outwards = 4 * 0x1p-53;
  double near = 0, far = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return std::nullopt;
      continue;
    }
    double first = (box.min[axis] - o) / d, last = (box.max[axis] - o) / d;
    if (first > last) std::swap(first, last);
    near = std::max(near, first * (first > 0 ? 1 - outwards : 1 + outwards));
    far = std::min(far, last * (last > 0 ? 1 + outwards : 1 - outwards));
  }
  if (near > far) return std::nullopt;
  return near;
}

/// The t beyond which no box has to be looked at when a hit at `t` is known: further than t by more
/// than the errors of two hits, 2^-20 each and less than the smallest number of full precision.
double no_further_than(double t) { return t * (1 + 0x1p-18) + std::numeric_limits<double>::min(); }

int longest_axis(const Box3& box) {
  const Vec3 d = box.max - box.min;
  return d.x >= d.y && d.x >= d.z ? 0 : d.y >= d.z ? 1 : 2;
}

}  // namespace

RayQuery::RayQuery(geometry::TriangleMesh mesh) : mesh_(std::move(mesh)) {
  geometry::check_mesh("mesh", mesh_);
  order_.resize(mesh_.triangles.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::vector<Vec3> centers;
  centers.reserve(mesh_.triangles.size());
  for (const auto& [a, b, c] : mesh_.triangles)
    centers.push_back(mesh_.positions[a] / 3.0 + mesh_.positions[b] / 3.0 +
                      mesh_.positions[c] / 3.0);
  build(0, std::uint32_t(order_.size()), centers);
}

/// Splits at the middle triangle along the longest axis: the depth is the logarithm, whatever the
/// mesh. Returns the node's number.
std::uint32_t RayQuery::build(std::uint32_t begin, std::uint32_t end,
                              const std::vector<Vec3>& centers) {
  const auto number = std::uint32_t(nodes_.size());
  nodes_.emplace_back();
  Box3 box, of_centers;
  for (std::uint32_t i = begin; i < end; ++i) {
    for (const std::uint32_t v : mesh_.triangles[order_[i]]) box.extend(mesh_.positions[v]);
    of_centers.extend(centers[order_[i]]);
  }
  nodes_[number] = {box, begin, end - begin};
  if (end - begin <= leaf_size) return number;
  const int axis = longest_axis(of_centers);
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
      [&](std::uint32_t p, std::uint32_t q) { return centers[p][axis] < centers[q][axis]; });
  build(begin, middle, centers);
  const std::uint32_t right = build(middle, end, centers);
  nodes_[number].right = right;
  nodes_[number].count = 0;
  return number;
}

/// Calls hit(RayHit) for every crossing, in any order, but for those beyond `farthest`, which hit()
/// may lower.
template <class Visit>
void RayQuery::visit(const FreeRay& ray, const double& farthest, const Visit& hit) const {
  check(ray);
  struct Waiting {
    std::uint32_t node;
    double from;
  } waiting[64];  // a tree of 2^32 triangles is 32 deep
  int count = 0;
  const auto wait = [&](std::uint32_t node, std::optional<double> from) {
    if (from) waiting[count++] = {node, *from};
  };
  wait(0, earliest(ray, nodes_[0].box));
  while (count > 0) {
    const auto [number, from] = waiting[--count];
    if (from > farthest) continue;
    const Node& node = nodes_[number];
    if (node.count == 0) {
      const auto left = earliest(ray, nodes_[number + 1].box);
      const auto right = earliest(ray, nodes_[node.right].box);
      const bool left_first = left < right;  // the nearer one is put last, and taken first
      if (left_first) wait(node.right, right);
      wait(number + 1, left);
      if (!left_first) wait(node.right, right);
    }
    for (std::uint32_t i = node.right; i < node.right + node.count; ++i) {
      const auto& [a, b, c] = mesh_.triangles[order_[i]];
      const auto found = cross(ray, mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
      if (!found) continue;
      if (!std::isfinite(found->t))
        throw InputError(
            "ray: crosses at more than 1.8e308 of its direction; accepted: a longer direction");
      hit(RayHit{*found, order_[i]});
    }
  }
}

/// Hits nearer to each other than their errors get the t that decides which comes first.
void RayQuery::settle(const FreeRay& ray, RayHit& p, RayHit& q) const {
  if (no_further_than(std::min(p.t, q.t)) < std::max(p.t, q.t)) return;
  for (RayHit* hit : {&p, &q}) {
    const auto& [a, b, c] = mesh_.triangles[hit->triangle];
    hit->t = exact_t(ray, mesh_.positions[a], mesh_.positions[b], mesh_.positions[c]);
  }
}

std::vector<RayHit> RayQuery::all(const FreeRay& ray) const {
  std::vector<RayHit> hits;
  visit(ray, infinity, [&](const RayHit& hit) { hits.push_back(hit); });
  std::sort(hits.begin(), hits.end());
  for (std::size_t i = 0; i + 1 < hits.size(); ++i) settle(ray, hits[i], hits[i + 1]);
  std::sort(hits.begin(), hits.end());
  return hits;
}

std::optional<RayHit> RayQuery::first(const FreeRay& ray) const {
  std::optional<RayHit> nearest;
  double farthest = infinity;
  visit(ray, farthest, [&](RayHit hit) {
    if (nearest) settle(ray, *nearest, hit);
    if (nearest && !(hit < *nearest)) return;
    nearest = hit;
    farthest = no_further_than(hit.t);
  });
  return nearest;
}

std::size_t RayQuery::count(const FreeRay& ray) const {
  std::size_t count = 0;
  visit(ray, infinity, [&](const RayHit&) { ++count; });
  return count;
}

bool RayQuery::inside(const Vec3& point) const {
  // Any direction would do; one along an axis meets the fewest boxes.
  return count({point, Vec3(0, 0, 1)}) % 2 == 1;
}

}  // namespace pellucid::groundtruth
