#include "groundtruth/packet_test.h"

#include <algorithm>
#include <bit>

namespace pellucid {
namespace {

constexpr std::size_t width = PacketTest::width;

/// Edge functions of eight rays, and the smallest and largest of each ray's three.
struct PacketEdges {
  alignas(64) double e[3][width];
  alignas(64) double low[width], high[width];
};

/// A vertex as EdgeFunctions shears it, (x - ray.x · z, y - ray.y · z). Orthographic rays are
/// sheared with z = 1, which multiplies without rounding.
struct ShearedVertex {
  double x, y, z;
};

/// The sums and products of CrossingTest, in the same order, so that no bit differs.
[[gnu::always_inline]] inline void compute(const double* x, const double* y, const ShearedVertex& a,
                                           const ShearedVertex& b, const ShearedVertex& c,
                                           PacketEdges& out) {
  for (std::size_t i = 0; i < width; ++i) {
    const double ax = a.x - x[i] * a.z, ay = a.y - y[i] * a.z;
    const double bx = b.x - x[i] * b.z, by = b.y - y[i] * b.z;
    const double cx = c.x - x[i] * c.z, cy = c.y - y[i] * c.z;
    const double e0 = bx * cy - by * cx, e1 = cx * ay - cy * ax, e2 = ax * by - ay * bx;
    out.e[0][i] = e0;
    out.e[1][i] = e1;
    out.e[2][i] = e2;
    const double low = e0 < e1 ? e0 : e1, high = e0 < e1 ? e1 : e0;
    out.low[i] = low < e2 ? low : e2;
    out.high[i] = high < e2 ? e2 : high;
  }
}

using Compute = void(const double*, const double*, const ShearedVertex&, const ShearedVertex&,
                     const ShearedVertex&, PacketEdges&);

void compute_anywhere(const double* x, const double* y, const ShearedVertex& a,
                      const ShearedVertex& b, const ShearedVertex& c, PacketEdges& out) {
  compute(x, y, a, b, c, out);
}

#if defined(__x86_64__)
/// Four lanes an instruction. Not FMA: it would round differently.
[[gnu::target("avx2")]] void compute_avx2(const double* x, const double* y, const ShearedVertex& a,
                                          const ShearedVertex& b, const ShearedVertex& c,
                                          PacketEdges& out) {
  compute(x, y, a, b, c, out);
}

Compute* fastest() { return __builtin_cpu_supports("avx2") ? compute_avx2 : compute_anywhere; }
#else
Compute* fastest() { return compute_anywhere; }
#endif

ShearedVertex sheared(const Vec3& a, Projection projection) {
  return {a.x, a.y, projection == Projection::perspective ? a.z : 1};
}

}  // namespace

void PacketTest::set(std::size_t lane, const CrossingTest& test) {
  tests_[lane] = &test;
  x_[lane] = test.ray().x;
  y_[lane] = test.ray().y;
}

std::uint32_t PacketTest::crosses(const Vec3& a, const Vec3& b, const Vec3& c, std::uint32_t lanes,
                                  std::array<EdgeFunctions, width>& edges) const {
  static Compute* const compute_edges = fastest();
  const Projection projection = tests_.front()->ray().projection;
  PacketEdges all;
  compute_edges(x_.data(), y_.data(), sheared(a, projection), sheared(b, projection),
                sheared(c, projection), all);
  std::uint32_t crossed = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const double bound = tests_[i]->bound();
    if (all.low[i] < -bound && all.high[i] > bound) continue;
    edges[i] = {{all.e[0][i], all.e[1][i], all.e[2][i]}};
    const bool certain = all.low[i] > bound || all.high[i] < -bound;
    if (certain || tests_[i]->crosses_uncertain(a, b, c, edges[i])) crossed |= 1u << i;
  }
  return crossed;
}

}  // namespace pellucid
