// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/rays/packet_predicate.h"

#include <algorithm>
#include <bit>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace pellucid::groundtruth {
namespace {

constexpr std::size_t width = PacketPredicate::width;

/// Edge functions of eight rays, and which rays they decide by themselves (bit i: ray i).
struct PacketEdges {
  alignas(64) double e[3][width];
  std::uint32_t inside, outside;
};

/// A vertex as EdgeFunctions shears it, (x - ray.x · z, y - ray.y · z). Orthographic rays are
/// sheared with z = 1, which multiplies without rounding.
struct ShearedVertex {
  double x, y, z;
};

/// Rays as the test needs them, lane by lane.
struct Lanes {
  const double *x, *y, *bound;
};

using Triangle = std::array<ShearedVertex, 3>;

/// The sums and products of RayPredicate, in the same order, so that no bit differs.
[[gnu::always_inline]] inline void compute(const Lanes& rays, const Triangle& triangle,
                                           PacketEdges& out) {
  const auto& [a, b, c] = triangle;
  for (std::size_t i = 0; i < width; ++i) {
    const double ax = a.x - rays.x[i] * a.z, ay = a.y - rays.y[i] * a.z;
    const double bx = b.x - rays.x[i] * b.z, by = b.y - rays.y[i] * b.z;
    const double cx = c.x - rays.x[i] * c.z, cy = c.y - rays.y[i] * c.z;
    out.e[0][i] = bx * cy - by * cx;
    out.e[1][i] = cx * ay - cy * ax;
    out.e[2][i] = ax * by - ay * bx;
  }
}

using Decide = void(const Lanes&, const Triangle&, PacketEdges&);

void decide_anywhere(const Lanes& rays, const Triangle& triangle, PacketEdges& out) {
  compute(rays, triangle, out);
  out.inside = out.outside = 0;
  for (std::size_t i = 0; i < width; ++i) {
    const double low = std::min({out.e[0][i], out.e[1][i], out.e[2][i]});
    const double high = std::max({out.e[0][i], out.e[1][i], out.e[2][i]});
    const double bound = rays.bound[i];
    out.inside |= std::uint32_t(low > bound || high < -bound) << i;
    out.outside |= std::uint32_t(low < -bound && high > bound) << i;
  }
}

#if defined(__x86_64__)
/// Four lanes an instruction. Not FMA: it would round differently.
[[gnu::target("avx2")]] void decide_avx2(const Lanes& rays, const Triangle& triangle,
                                         PacketEdges& out) {
  compute(rays, triangle, out);
  out.inside = out.outside = 0;
  for (std::size_t i = 0; i < width; i += 4) {
    const __m256d e0 = _mm256_load_pd(out.e[0] + i), e1 = _mm256_load_pd(out.e[1] + i),
                  e2 = _mm256_load_pd(out.e[2] + i);
    const __m256d low = _mm256_min_pd(_mm256_min_pd(e0, e1), e2);
    const __m256d high = _mm256_max_pd(_mm256_max_pd(e0, e1), e2);
    const __m256d bound = _mm256_load_pd(rays.bound + i), below = _mm256_set1_pd(0) - bound;
    const __m256d above_all = _mm256_cmp_pd(low, bound, _CMP_GT_OQ);
    const __m256d below_all = _mm256_cmp_pd(high, below, _CMP_LT_OQ);
    const __m256d reaches_below = _mm256_cmp_pd(low, below, _CMP_LT_OQ);
    const __m256d reaches_above = _mm256_cmp_pd(high, bound, _CMP_GT_OQ);
    out.inside |= unsigned(_mm256_movemask_pd(_mm256_or_pd(above_all, below_all))) << i;
    out.outside |= unsigned(_mm256_movemask_pd(_mm256_and_pd(reaches_below, reaches_above))) << i;
  }
}

Decide* fastest() { return __builtin_cpu_supports("avx2") ? decide_avx2 : decide_anywhere; }
#else
Decide* fastest() { return decide_anywhere; }
#endif

ShearedVertex sheared(const Vec3& a, scene::Projection projection) {
  return {a.x, a.y, projection == scene::Projection::perspective ? a.z : 1};
}

}  // namespace

void PacketPredicate::set(std::size_t lane, const RayPredicate& predicate) {
  predicates_[lane] = &predicate;
  x_[lane] = predicate.ray().x;
  y_[lane] = predicate.ray().y;
  bound_[lane] = predicate.bound();
}

std::uint32_t PacketPredicate::crosses(const Vec3& a, const Vec3& b, const Vec3& c,
                                       std::uint32_t lanes,
                                       std::array<EdgeFunctions, width>& edges) const {
  static Decide* const decide = fastest();
  const scene::Projection projection = predicates_.front()->ray().projection;
  PacketEdges all;
  decide({x_.data(), y_.data(), bound_.data()},
         {sheared(a, projection), sheared(b, projection), sheared(c, projection)}, all);
  const auto edges_of = [&](int i) {
    return EdgeFunctions{{all.e[0][i], all.e[1][i], all.e[2][i]}};
  };
  std::uint32_t crossed = lanes & all.inside;
  for (std::uint32_t rest = crossed; rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    edges[i] = edges_of(i);
  }
  for (std::uint32_t rest = lanes & ~(all.inside | all.outside); rest != 0; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    edges[i] = edges_of(i);
    if (predicates_[i]->crosses_uncertain(a, b, c, edges[i])) crossed |= 1u << i;
  }
  return crossed;
}

}  // namespace pellucid::groundtruth
