// SPDX-License-Identifier: GPL-3.0-or-later
// Where a ray crosses a triangle that is seen far narrower than long, against exact rationals: the
// barycentric coordinates that depth, colour and importance are interpolated by.
#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include <random>

#include "groundtruth/rays/exact_sign.h"

namespace pellucid::groundtruth {
namespace {

using Number = CGAL::Exact_rational;
using Triangle = std::array<Vec3, 3>;

/// a' × b' as EdgeFunctions has it.
Number edge(const PictureRay& ray, const Vec3& a, const Vec3& b) {
  const bool perspective = ray.projection == scene::Projection::perspective;
  const auto x = [&](const Vec3& p) -> Number {
    return Number(p.x) - Number(ray.x) * (perspective ? Number(p.z) : Number(1));
  };
  const auto y = [&](const Vec3& p) -> Number {
    return Number(p.y) - Number(ray.y) * (perspective ? Number(p.z) : Number(1));
  };
  return x(a) * y(b) - y(a) * x(b);
}

std::array<double, 3> exact_weights(const PictureRay& ray, const Triangle& t) {
  const Number e[] = {edge(ray, t[1], t[2]), edge(ray, t[2], t[0]), edge(ray, t[0], t[1])};
  const Number sum = e[0] + e[1] + e[2];
  const auto share = [&](int k) { return CGAL::to_double(Number(e[k] / sum)); };
  return {share(0), share(1), share(2)};
}

class PropertySlivers : public ::testing::TestWithParam<std::tuple<scene::Projection, double>> {
 protected:
  double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

  /// A triangle with its vertices `width` off a line that is seen to pass through the ray.
  Triangle sliver(const PictureRay& ray, double width) {
    const Vec3 through(ray.x, ray.y, 1), along(uniform(), uniform(), 0);
    Triangle t;
    for (const double place : {-0.9, 0.2, 0.8}) {
      const double depth = 1.5 + 0.4 * uniform();
      const bool perspective = ray.projection == scene::Projection::perspective;
      const Vec3 seen = through + place * along + width * Vec3(uniform(), uniform(), 0);
      t[std::size_t(place > 0) + std::size_t(place > 0.5)] =
          perspective ? seen * depth : Vec3(seen.x, seen.y, depth);
    }
    return t;
  }
  std::mt19937 random_{7};
};

TEST_P(PropertySlivers, AreCrossedWhereTheyAre) {
  const auto [projection, width] = GetParam();
  int crossed = 0;
  for (int round = 0; round < 3000; ++round) {
    const PictureRay ray{0.3 * uniform(), 0.3 * uniform(), projection};
    const Triangle t = sliver(ray, width);
    const RayPredicate predicate(ray, 4, Precision::exact);
    EdgeFunctions edges;
    if (!predicate.crosses(t[0], t[1], t[2], edges)) continue;
    ++crossed;
    predicate.sharpen(t[0], t[1], t[2], edges);
    const std::array<double, 3> expected = exact_weights(ray, t);
    const double sum = edges.e[0] + edges.e[1] + edges.e[2];
    // What sharpen() promises; computed without rounding, three roundings of what is below 1.
    for (std::size_t k = 0; k < 3; ++k)
      ASSERT_NEAR(edges.e[k] / sum, expected[k], width < 1e-10 ? 0x1p-51 : 3 * 0x1p-20) << round;
  }
  EXPECT_GT(crossed, 300) << "the rays miss the slivers";
}

INSTANTIATE_TEST_SUITE_P(Of, PropertySlivers,
                         ::testing::Combine(::testing::Values(scene::Projection::perspective,
                                                              scene::Projection::orthographic),
                                            ::testing::Values(1e-3, 1e-7, 1e-11, 1e-14, 1e-15)));

}  // namespace
}  // namespace pellucid::groundtruth
