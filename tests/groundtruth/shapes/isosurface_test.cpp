// SPDX-License-Identifier: GPL-3.0-or-later
// Exact crossings with isosurfaces: closed forms, then bisection.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "groundtruth/levels/level_march.h"
#include "groundtruth/levels/ray_polynomial.h"
#include "tests/groundtruth/levels.h"

namespace pellucid::groundtruth {
namespace {

TEST(UnitRayPolynomial, FindsTheRootsOfAProduct) {
  RayPolynomial p(1.0);
  const std::vector<double> roots{0.1, 0.25, 0.5, 0.5000001, 0.9};
  for (const double root : roots) p = p * RayPolynomial(-root, 1 - root);
  std::vector<double> found;
  append_sign_changes(p, found);
  ASSERT_EQ(found.size(), roots.size());
  // Two roots 1e-7 apart: an error of 1e-16 in p moves them by 1e-16 / (1e-7 · slope 1e-2).
  for (std::size_t i = 0; i < roots.size(); ++i) EXPECT_NEAR(found[i], roots[i], 1e-7);
  EXPECT_NEAR(found[0], 0.1, 1e-13);
}

TEST(UnitRayPolynomial, CountsAZeroEndAsPositive) {
  std::vector<double> found;
  append_sign_changes(RayPolynomial(0, 1), found);
  EXPECT_TRUE(found.empty());
  append_sign_changes(RayPolynomial(0, -1), found);
  EXPECT_EQ(found, std::vector<double>{0});
  found.clear();
  append_sign_changes(RayPolynomial(0.0), found);  // a plateau
  EXPECT_TRUE(found.empty());
}

class PropertyIsosurface : public ::testing::TestWithParam<fields::ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyIsosurface, ::testing::ValuesIn(fields::reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyIsosurface, GridAlignedRaysCrossAPlaneOnce) {
  const fields::LevelField field = nested([](const Vec3& x) { return x.x; }, GetParam());
  // Rays through samples, cell faces and level faces, both ways; the plane on each of those, too.
  for (const double value : {1.5, 1.7, 3.0, 3.25, 3.5, 4.125})
    for (const double y : {1.5, 2.0, 2.25, 3.75, 4.0, 6.0, 6.5})
      for (const double z : {2.0, 2.25, 5.0, 6.0}) {
        const auto forth = exact_crossings(field, value, {Vec3(-5, y, z), Vec3(1, 0, 0)});
        const auto back = exact_crossings(field, value, {Vec3(15, y, z), Vec3(-1, 0, 0)});
        ASSERT_EQ(forth.size(), 1u) << value << ' ' << y << ' ' << z;
        ASSERT_EQ(back.size(), 1u) << value << ' ' << y << ' ' << z;
        // Parameters up to 20, whose ulp is 3.6e-15: three of them. Measured 9e-16.
        EXPECT_NEAR(forth[0] - 5, 15 - back[0], 1e-14);
        if (GetParam().linear_preserving) {
          EXPECT_NEAR(forth[0] - 5, value, 1e-14);
        }
      }
}

TEST_P(PropertyIsosurface, RaysThroughFacesCrossAPlaneOnce) {
  // In the planes between cells and along the diagonals of their edges.
  const fields::LevelField field = nested([](const Vec3& x) { return x.x; }, GetParam());
  for (const Vec3 direction : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(1, 1, 1), Vec3(2, 1, 0)})
    for (const Vec3 through : {Vec3(3.25, 4.25, 4.25), Vec3(3, 4, 4), Vec3(2, 2, 2.5)}) {
      const double value = through.x + 0.125;
      EXPECT_EQ(exact_crossings(field, value, {through - 3.0 * direction, direction}).size(), 1u);
    }
}

TEST_P(PropertyIsosurface, RandomRaysAgreeWithBisection) {
  const fields::LevelField field = nested(wavy, GetParam());
  constexpr double value = 0.05, step = 1.0 / 512;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0.7, 7.3);
  const auto any = [&] { return Vec3(uniform(random), uniform(random), uniform(random)); };
  std::size_t bisected = 0;
  for (int i = 0; i < 60; ++i) {
    const Vec3 a = any(), b = any();
    const WorldRay ray{a, glm::normalize(b - a)};
    const auto inside = [&](double t) { return field.value(ray.at(t)).value() >= value; };
    auto found = exact_crossings(field, value, ray);
    std::erase_if(found, [&](double t) { return t > glm::length(b - a); });
    for (double t = 0; t + step < glm::length(b - a); t += step) {
      if (inside(t) == inside(t + step)) continue;
      double low = t, high = t + step;
      for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (inside(middle) == inside(low) ? low : high) = middle;
      }
      ++bisected;
      // 1e-9 of the finest cell. Where it jumps, single signs at the face may differ.
      EXPECT_TRUE(std::ranges::any_of(found, [&](double at) {
        return std::abs(at - low) < 0.5e-9;
      })) << low;
    }
    // Signs alternate, so that their number is as odd as the ends are different.
    EXPECT_EQ(found.size() % 2 == 1, inside(0) != inside(glm::length(b - a)));
  }
  EXPECT_GT(bisected, 30u);
}

TEST_P(PropertyIsosurface, APlateauAtTheValueIsBoundedAndNotFilled) {
  const auto plateau = [](const Vec3& x) { return std::min(x.x - 4, 0.0); };
  const fields::LevelField field({sampled(Vec3(0), 1, 9, plateau)}, GetParam());
  EXPECT_EQ(exact_crossings(field, 0, {Vec3(-1, 3.3, 3.7), Vec3(1, 0, 0)}), std::vector<double>{5});
}

/// The highest value is that of one layer of samples, on the faces between cells.
TEST_P(PropertyIsosurface, ASurfaceThatIsTouchedOnAFaceIsNotCrossed) {
  const auto ridge = [](const Vec3& x) { return -std::abs(x.x - 4); };
  const auto edge = [](const Vec3& x) { return -std::abs(x.x - 4) - std::abs(x.y - 4); };
  const fields::LevelField on_face({sampled(Vec3(0), 1, 9, ridge)}, GetParam());
  const fields::LevelField on_line({sampled(Vec3(0), 1, 9, edge)}, GetParam());
  const fields::LevelField other_side(
      {sampled(Vec3(0), 1, 9, [&](const Vec3& x) { return -ridge(x); })}, GetParam());
  const Vec3 through(4, 4, 3.7);
  for (const Vec3& direction :
       {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(1, 0.5, 0), Vec3(1, -1, 0.25)}) {
    const WorldRay ray{through - 6.0 * direction, direction};
    EXPECT_TRUE(exact_crossings(on_face, 0, ray).empty());
    EXPECT_TRUE(exact_crossings(on_line, 0, ray).empty());
    EXPECT_TRUE(exact_crossings(other_side, 0, ray).empty());
    EXPECT_EQ(exact_crossings(on_face, -0.25, ray).size(), 2u);
  }
}

TEST_P(PropertyIsosurface, ValuesOutOfRangeHaveNoSurface) {
  const fields::LevelField field = nested([](const Vec3& x) { return x.x; }, GetParam());
  EXPECT_TRUE(surface_cells(field, 100).empty());
  EXPECT_TRUE(surface_cells(field, -100).empty());
}

/// 9 at the fine box's upper face in a coarse level of -1: what jumps across the value are no
/// samples of one cell. Widths and places that are no sums of a few powers of two put a point on a
/// face to either side.
TEST(UnitIsosurface, AJumpBetweenCellsThatDoNotTakeTheValueIsCrossed) {
  const fields::LevelField field(
      {sampled(Vec3(-0.85, -0.82, -0.86), 0.2, 9, [](const Vec3&) { return -1; }),
       sampled(Vec3(-0.4, -0.37, -0.41), 0.1, 9, [](const Vec3& x) { return 10 * x.x + 5; })},
      fields::find_reconstruction("trilinear"));
  for (const double value : {1.5, 2.01, 4.5})
    for (int i = 0; i < 49; ++i) {
      const double y = -0.3 + 0.09 * (i % 7), z = -0.31 + 0.09 * (i / 7);
      for (const WorldRay& ray :
           {WorldRay{Vec3(3, y, z), Vec3(-1, 0, 0)}, WorldRay{Vec3(-3, y, z), Vec3(1, 0, 0)},
            WorldRay{Vec3(3, 1.1 * y, z), Vec3(-1, -0.01 * y, 0.02)}})
        EXPECT_EQ(exact_crossings(field, value, ray).size(), 2u) << value << ' ' << y << ' ' << z;
    }
}

TEST(UnitIsosurface, ASphereIsEnteredAndLeft) {
  const auto distance = [](const Vec3& x) { return glm::length(x - 4.0); };
  const fields::LevelField field({sampled(Vec3(0), 0.125, 65, distance)},
                                 fields::find_reconstruction("blend"));
  const auto at = exact_crossings(field, 2, {Vec3(-2, 4, 4), Vec3(1, 0, 0)});
  ASSERT_EQ(at.size(), 2u);
  // Along the axis through samples the reconstruction is linear: |x - 4| up to float.
  EXPECT_NEAR(at[0], 4, 1e-6);
  EXPECT_NEAR(at[1], 8, 1e-6);
}

// The sample of a coarse cell at the end lies under a fine level, the end of the cell does not:
// there no hat reaches, and nothing is inside or outside.
TEST(UnitIsosurface, WhereNoHatReachesThereIsNoCrossing) {
  for (const double value : {-1.0, 1.0}) {
    const auto constant = [&](const Vec3&) { return value; };
    const fields::LevelField field(
        {sampled(Vec3(0), 1, 3, constant), sampled(Vec3(1), 0.25, 5, constant)},
        fields::find_reconstruction("hat"));
    EXPECT_FALSE(field.value(Vec3(2.45, 1.5, 1.5)));
    EXPECT_FALSE(field.gradient(Vec3(2.45, 1.5, 1.5)));
    for (double y = -0.4; y < 2.5; y += 0.1)
      for (double z = -0.4; z < 2.5; z += 0.1)
        for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(1, 0.1, -0.2)}) {
          const WorldRay ray{Vec3(1, y, z) - 8.0 * direction, direction};
          EXPECT_TRUE(exact_crossings(field, 0, ray).empty()) << value << ' ' << y << ' ' << z;
          LevelMarch(field, 0, {}).visit_crossings(ray, [&](double) -> bool {
            ADD_FAILURE() << "a march crosses " << value << " at " << y << ' ' << z;
            return true;
          });
        }
  }
}

// Levels anywhere: every crossing is where values of both signs are, or at a jump between them.
TEST_P(PropertyIsosurface, CrossesWhereValuesOfBothSignsMeet) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0, 1);
  std::size_t count = 0;
  for (int n = 0; n < 60; ++n) {
    std::vector<fields::ScalarLevel> levels;
    for (const double width : {0.25, 0.5, 0.5, 1.0})
      levels.push_back(sampled(4.0 * Vec3(unit(random), unit(random), unit(random)), width,
                               3 + int(4 * unit(random)), wavy));
    const fields::LevelField field(levels, GetParam());
    for (int i = 0; i < 40; ++i) {
      const Vec3 target = 6.0 * Vec3(unit(random), unit(random), unit(random));
      const Vec3 direction = glm::normalize(Vec3(unit(random), unit(random), unit(random)) - 0.5);
      const WorldRay ray{target - 20.0 * direction, direction};
      for (const double t : exact_crossings(field, 0, ray)) {
        ++count;
        // A step beside it, where the field goes on: slopes are at most some 100.
        const auto before = field.value(ray.at(t - 1e-9)), after = field.value(ray.at(t + 1e-9));
        ASSERT_TRUE(before || after);
        if (before && after) {
          EXPECT_NE(*before < 0, *after < 0) << *before << ' ' << *after;
        } else {
          EXPECT_NEAR(before ? *before : *after, 0, 1e-6);
        }
      }
    }
  }
  EXPECT_GT(count, 500u);
}

}  // namespace
}  // namespace pellucid::groundtruth
