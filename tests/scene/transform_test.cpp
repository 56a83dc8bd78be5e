// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/transform.h"

#include <gtest/gtest.h>

#include <random>

#include "core/error.h"

namespace pellucid::scene {
namespace {

geometry::Vertices one(const Vec3& x, const Vec3& n = Vec3(0)) {
  geometry::Vertices vertices;
  vertices.positions = {x};
  vertices.normals = {n};
  return vertices;
}

Vec3 moved(const Transform& by, const Vec3& x) {
  geometry::Vertices vertices = one(x);
  transform(by, vertices);
  return vertices.positions[0];
}

TEST(UnitTransform, ScalesThenTurnsThenShifts) {
  // (1, 1, 0) → (2, 3, 0) → a quarter about z → (-3, 2, 0) → (7, 2, 1), all of it exact.
  EXPECT_EQ(moved({{2, 3, 4}, {0, 0, 5}, 90, {10, 0, 1}}, {1, 1, 0}), Vec3(7, 2, 1));
  EXPECT_EQ(moved({Vec3(1), {0, 1, 0}, -90, Vec3(0)}, {1, 0, 0}), Vec3(0, 0, 1));
  EXPECT_EQ(moved({Vec3(1), {1, 0, 0}, 540, Vec3(0)}, {1, 2, 3}), Vec3(1, -2, -3));
  EXPECT_EQ(moved({Vec3(-1), {1, 2, 3}, 0, Vec3(0)}, {1, 2, 3}), Vec3(-1, -2, -3));
  EXPECT_EQ(moved({}, {0.1, -7, 1e200}), Vec3(0.1, -7, 1e200));
}

TEST(UnitTransform, AThirdOfATurnAboutTheDiagonalExchangesTheAxes) {
  // Sines and the axis' length round by some 1e-16 each.
  EXPECT_LE(glm::length(moved({Vec3(1), Vec3(1), 120, Vec3(0)}, {1, 2, 3}) - Vec3(3, 1, 2)), 4e-15);
}

TEST(PropertyTransform, NormalsStayPerpendicular) {
  std::mt19937 random(20);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto vector = [&] { return Vec3(unit(random), unit(random), unit(random)); };
  for (int round = 0; round < 300; ++round) {
    const Transform by{vector() + Vec3(1.5), vector(), 500 * unit(random), vector()};
    const Vec3 a = vector(), b = vector(), along = vector();
    const Vec3 n = glm::normalize(glm::cross(along, b));
    geometry::Vertices vertices = one(a, n);
    transform(by, vertices);
    const Vec3 tangent = moved(by, a + along) - vertices.positions[0];
    // Scales from 0.5 to 2.5 and vectors up to 2: some 20 roundings of 2e-16.
    EXPECT_NEAR(glm::dot(vertices.normals[0], tangent), 0, 1e-13);
    EXPECT_NEAR(glm::length(vertices.normals[0]), 1, 1e-15);
  }
}

TEST(UnitTransform, RefusesWhatLeavesTheNumbers) {
  geometry::Vertices vertices = one({1e299, 0, 0});
  EXPECT_THROW(transform({Vec3(100), {0, 0, 1}, 0, Vec3(0)}, vertices), InputError);
}

}  // namespace
}  // namespace pellucid::scene
