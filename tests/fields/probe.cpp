// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fields/probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fields/make_field.h"

namespace pellucid::fields {

std::string text_of(const Vec3& v) { return fmt::format("({}, {}, {})", v.x, v.y, v.z); }

Vec3 velocity_of(const VectorField& field, const Vec3& x, double t) {
  Vec3 v(0);
  EXPECT_EQ(field.sampler()->velocity(x, t, v), SampleStatus::ok) << "at " << text_of(x);
  return v;
}

Vec3 velocity_of(std::string_view field, const Vec3& x, double t) {
  return velocity_of(*make_field(field), x, t);
}

SampleStatus status_at(const VectorField& field, const Vec3& x, double t) {
  Vec3 v;
  return field.sampler()->velocity(x, t, v);
}

double divergence(const Mat3& jacobian) { return jacobian[0][0] + jacobian[1][1] + jacobian[2][2]; }

double norm(const Mat3& m) {
  double largest = 0;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(m[j][i]));
  return largest;
}

void expect_consistent_jacobian(const VectorField& field, const Vec3& x, double t, double step,
                                double tolerance) {
  const auto sampler = field.sampler();
  Vec3 v, with_jacobian;
  Mat3 jacobian;
  ASSERT_EQ(sampler->velocity(x, t, v), SampleStatus::ok);
  ASSERT_EQ(sampler->velocity_and_jacobian(x, t, with_jacobian, jacobian), SampleStatus::ok);
  EXPECT_NEAR_VEC(with_jacobian, v, 1e-15 * (1 + glm::length(v)));
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 offset(0);
    offset[axis] = step;
    Vec3 before, behind;
    ASSERT_EQ(sampler->velocity(x - offset, t, before), SampleStatus::ok);
    ASSERT_EQ(sampler->velocity(x + offset, t, behind), SampleStatus::ok);
    EXPECT_NEAR_VEC(jacobian[axis], (behind - before) / (2 * step), tolerance)
        << " at " << text_of(x) << " along axis " << axis;
  }
}

std::string test_name(std::string_view name) {
  std::string valid(name);
  for (char& c : valid)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return valid;
}

}  // namespace pellucid::fields
