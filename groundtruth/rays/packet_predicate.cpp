// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/packet_predicate.h"

#include <algorithm>
#include <bit>
#include <cmath>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "groundtruth/rays/triangle_point.h"

namespace pellucid::groundtruth {
namespace {

constexpr std::size_t width = PacketPredicate::width;

/// Edge functions of the rays that are asked about, and which of them they decide by themselves
/// (bit i: ray i).
struct PacketEdges {
  alignas(64) double e[3][width];
  std::uint32_t inside = 0, outside = 0;

  EdgeFunctions of(int ray) const { return {{e[0][ray], e[1][ray], e[2][ray]}}; }
  void set(int ray, const EdgeFunctions& edges) {
    for (int k = 0; k < 3; ++k) e[k][ray] = edges.e[k];
  }
};

/// A vertex as EdgeFunctions shears it, (x - ray.x · z, y - ray.y · z). Orthographic rays are
/// sheared with z = 1, which multiplies without rounding.
struct ShearedVertex {
  double x, y, z;
};

/// Rays as the test needs them, lane by lane, and those of them that are asked about.
struct Lanes {
  const double *x, *y, *bound;
  std::uint32_t asked;
};

using Triangle = std::array<ShearedVertex, 3>;

// A Decide computes the sums and products of RayPredicate, a Locate those of triangle_point(), in
// the same order, so that no bit differs. A Locate returns which rays have to be sharpened.
using Decide = void(const Lanes&, const Triangle&, PacketEdges&);
using Locate = std::uint32_t(const PacketEdges&, std::uint32_t crossed, const double* sharp_from,
                             const Vec3& depths, PacketPredicate::Points&);

/// Returns the rays that pass a sheared point within √(limit · stretch + slack), `limit` a square.
using PassNear = std::uint32_t(const Lanes&, const ShearedVertex&, const double* stretch,
                               double limit, double slack);

void store(PacketPredicate::Points& points, int ray, const TrianglePoint& point) {
  const auto i = std::size_t(ray);
  points.depth[i] = point.depth;
  points.u[i] = point.u;
  points.v[i] = point.v;
}

void decide_anywhere(const Lanes& rays, const Triangle& triangle, PacketEdges& out) {
  const auto& [a, b, c] = triangle;
  for (std::size_t i = 0; i < width; ++i) {
    const double ax = a.x - rays.x[i] * a.z, ay = a.y - rays.y[i] * a.z;
    const double bx = b.x - rays.x[i] * b.z, by = b.y - rays.y[i] * b.z;
    const double cx = c.x - rays.x[i] * c.z, cy = c.y - rays.y[i] * c.z;
    out.e[0][i] = bx * cy - by * cx;
    out.e[1][i] = cx * ay - cy * ax;
    out.e[2][i] = ax * by - ay * bx;
    const double low = std::min({out.e[0][i], out.e[1][i], out.e[2][i]});
    const double high = std::max({out.e[0][i], out.e[1][i], out.e[2][i]});
    const double bound = rays.bound[i];
    out.inside |= std::uint32_t(low > bound || high < -bound) << i;
    out.outside |= std::uint32_t(low < -bound && high > bound) << i;
  }
}

std::uint32_t locate_anywhere(const PacketEdges& edges, std::uint32_t crossed,
                              const double* sharp_from, const Vec3& depths,
                              PacketPredicate::Points& out) {
  const Vec3 a(0, 0, depths.x), b(0, 0, depths.y), c(0, 0, depths.z);
  std::uint32_t narrow = 0;
  for (std::uint32_t rest = crossed; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const EdgeFunctions at = edges.of(i);
    if (std::abs(at.e[0] + at.e[1] + at.e[2]) < sharp_from[i]) narrow |= 1u << i;
    store(out, i, triangle_point(at, a, b, c));
  }
  return narrow;
}

std::uint32_t pass_near_anywhere(const Lanes& rays, const ShearedVertex& c, const double* stretch,
                                 double limit, double slack) {
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const double x = c.x - rays.x[i] * c.z, y = c.y - rays.y[i] * c.z;
    near |= std::uint32_t(x * x + y * y <= limit * stretch[i] + slack) << i;
  }
  return near;
}

#if defined(__x86_64__)
// Four lanes an instruction; fours of which none is asked about are passed over. Not FMA: it would
// round differently.

[[gnu::target("avx2")]] void decide_avx2(const Lanes& rays, const Triangle& triangle,
                                         PacketEdges& out) {
  __m256d vertex[3][3];
  for (std::size_t k = 0; k < 3; ++k) {
    vertex[k][0] = _mm256_set1_pd(triangle[k].x);
    vertex[k][1] = _mm256_set1_pd(triangle[k].y);
    vertex[k][2] = _mm256_set1_pd(triangle[k].z);
  }
  for (std::size_t i = 0; i < width; i += 4) {
    if ((rays.asked >> i & 15) == 0) continue;
    const __m256d x = _mm256_load_pd(rays.x + i), y = _mm256_load_pd(rays.y + i);
    const __m256d ax = vertex[0][0] - x * vertex[0][2], ay = vertex[0][1] - y * vertex[0][2];
    const __m256d bx = vertex[1][0] - x * vertex[1][2], by = vertex[1][1] - y * vertex[1][2];
    const __m256d cx = vertex[2][0] - x * vertex[2][2], cy = vertex[2][1] - y * vertex[2][2];
    const __m256d e0 = bx * cy - by * cx, e1 = cx * ay - cy * ax, e2 = ax * by - ay * bx;
    const __m256d low = _mm256_min_pd(_mm256_min_pd(e0, e1), e2);
    const __m256d high = _mm256_max_pd(_mm256_max_pd(e0, e1), e2);
    const __m256d bound = _mm256_load_pd(rays.bound + i), below = _mm256_set1_pd(0) - bound;
    const __m256d above_all = _mm256_cmp_pd(low, bound, _CMP_GT_OQ);
    const __m256d below_all = _mm256_cmp_pd(high, below, _CMP_LT_OQ);
    const __m256d reaches_below = _mm256_cmp_pd(low, below, _CMP_LT_OQ);
    const __m256d reaches_above = _mm256_cmp_pd(high, bound, _CMP_GT_OQ);
    out.inside |= unsigned(_mm256_movemask_pd(_mm256_or_pd(above_all, below_all))) << i;
    out.outside |= unsigned(_mm256_movemask_pd(_mm256_and_pd(reaches_below, reaches_above))) << i;
    _mm256_store_pd(out.e[0] + i, e0);
    _mm256_store_pd(out.e[1] + i, e1);
    _mm256_store_pd(out.e[2] + i, e2);
  }
}

[[gnu::target("avx2")]] std::uint32_t locate_avx2(const PacketEdges& edges, std::uint32_t crossed,
                                                  const double* sharp_from, const Vec3& depths,
                                                  PacketPredicate::Points& out) {
  const __m256d no_sign = _mm256_castsi256_pd(_mm256_set1_epi64x(0x7fffffffffffffff));
  const __m256d zero = _mm256_setzero_pd(), middle = _mm256_set1_pd(TrianglePoint::middle);
  const __m256d at_a = _mm256_set1_pd(depths.x), to_b = _mm256_set1_pd(depths.y - depths.x),
                to_c = _mm256_set1_pd(depths.z - depths.x);
  std::uint32_t narrow = 0;
  for (std::size_t i = 0; i < width; i += 4) {
    if ((crossed >> i & 15) == 0) continue;
    const __m256d e0 = _mm256_load_pd(edges.e[0] + i), e1 = _mm256_load_pd(edges.e[1] + i),
                  e2 = _mm256_load_pd(edges.e[2] + i);
    const __m256d sum = e0 + e1 + e2;
    const __m256d none = _mm256_cmp_pd(sum, zero, _CMP_EQ_OQ);
    const __m256d u = _mm256_blendv_pd(e1 / sum, middle, none);
    const __m256d v = _mm256_blendv_pd(e2 / sum, middle, none);
    _mm256_store_pd(out.u.data() + i, u);
    _mm256_store_pd(out.v.data() + i, v);
    _mm256_store_pd(out.depth.data() + i, at_a + u * to_b + v * to_c);
    const __m256d size = _mm256_and_pd(sum, no_sign), least = _mm256_load_pd(sharp_from + i);
    narrow |= unsigned(_mm256_movemask_pd(_mm256_cmp_pd(size, least, _CMP_LT_OQ))) << i;
  }
  return narrow & crossed;
}

[[gnu::target("avx2")]] std::uint32_t pass_near_avx2(const Lanes& rays, const ShearedVertex& c,
                                                     const double* stretch, double limit,
                                                     double slack) {
  const __m256d cx = _mm256_set1_pd(c.x), cy = _mm256_set1_pd(c.y), cz = _mm256_set1_pd(c.z),
                squared = _mm256_set1_pd(limit), beside = _mm256_set1_pd(slack);
  std::uint32_t near = 0;
  for (std::size_t i = 0; i < width; i += 4) {
    const __m256d x = cx - _mm256_load_pd(rays.x + i) * cz,
                  y = cy - _mm256_load_pd(rays.y + i) * cz;
    const __m256d most = squared * _mm256_load_pd(stretch + i) + beside;
    const __m256d is_near = _mm256_cmp_pd(x * x + y * y, most, _CMP_LE_OQ);
    near |= unsigned(_mm256_movemask_pd(is_near)) << i;
  }
  return near;
}
#endif

struct Kernels {
  Decide* decide = decide_anywhere;
  Locate* locate = locate_anywhere;
  PassNear* pass_near = pass_near_anywhere;
};

const Kernels& kernels() {
  static const Kernels fastest = [] {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return Kernels{decide_avx2, locate_avx2, pass_near_avx2};
#endif
    return Kernels{};
  }();
  return fastest;
}

ShearedVertex sheared(const Vec3& a, scene::Projection projection) {
  return {a.x, a.y, projection == scene::Projection::perspective ? a.z : 1};
}

}  // namespace

void PacketPredicate::set(std::size_t lane, const RayPredicate& predicate) {
  predicates_[lane] = &predicate;
  x_[lane] = predicate.ray().x;
  y_[lane] = predicate.ray().y;
  bound_[lane] = predicate.bound();
  sharp_from_[lane] = predicate.sharp_from();
  const bool perspective = predicate.ray().projection == scene::Projection::perspective;
  stretch_[lane] = perspective ? 1 + x_[lane] * x_[lane] + y_[lane] * y_[lane] : 1;
  widest_ = std::max({widest_, std::abs(x_[lane]), std::abs(y_[lane])});
}

std::uint32_t PacketPredicate::crosses(const Vec3& a, const Vec3& b, const Vec3& c,
                                       std::uint32_t lanes, Points& points) const {
  const scene::Projection projection = predicates_.front()->ray().projection;
  PacketEdges edges;
  kernels().decide({x_.data(), y_.data(), bound_.data(), lanes},
                   {sheared(a, projection), sheared(b, projection), sheared(c, projection)}, edges);
  std::uint32_t crossed = lanes & edges.inside;
  for (std::uint32_t rest = lanes & ~(edges.inside | edges.outside); rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    EdgeFunctions decided = edges.of(i);
    if (!predicates_[i]->crosses_uncertain(a, b, c, decided)) continue;
    edges.set(i, decided);
    crossed |= 1u << i;
  }
  if (crossed == 0) return 0;
  for (std::uint32_t narrow =
           kernels().locate(edges, crossed, sharp_from_.data(), {a.z, b.z, c.z}, points);
       narrow != 0; narrow &= narrow - 1) {
    const int i = std::countr_zero(narrow);
    EdgeFunctions sharp = edges.of(i);
    predicates_[i]->sharpen(a, b, c, sharp);
    store(points, i, triangle_point(sharp, a, b, c));
  }
  return crossed;
}

/// A ball that a ray meets reaches, across the depth of its centre, no farther than its radius
/// times the length of (x, y, 1) from the ray; a disc its radius. `slack` is more than the
/// rounding, of a few units in the last place of the terms, here and where crossings are computed.
std::uint32_t PacketPredicate::may_meet(const Vec3& center, double radius,
                                        std::uint32_t lanes) const {
  constexpr double wider = 1 + 1e-9;
  const ShearedVertex c = sheared(center, predicates_.front()->ray().projection);
  const double size = std::max(std::abs(c.x), std::abs(c.y)) + widest_ * std::abs(c.z);
  return lanes & kernels().pass_near({x_.data(), y_.data(), bound_.data(), lanes}, c,
                                     stretch_.data(), wider * radius * radius,
                                     64 * 0x1p-53 * size * size);
}

}  // namespace pellucid::groundtruth
