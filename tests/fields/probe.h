// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "fields/field.h"

namespace pellucid::fields {

#define EXPECT_NEAR_VEC(actual, expected, tolerance)       \
  EXPECT_LE(glm::length((actual) - (expected)), tolerance) \
      << "got " << text_of(actual) << ", expected " << text_of(expected)

std::string text_of(const Vec3& v);

/// Velocity of make_field(field) at x; fails the test when there is none.
Vec3 velocity_of(std::string_view field, const Vec3& x, double t = 0);
Vec3 velocity_of(const VectorField& field, const Vec3& x, double t = 0);
SampleStatus status_at(const VectorField& field, const Vec3& x, double t = 0);

double divergence(const Mat3& jacobian);
double norm(const Mat3& m);  // largest entry

/// The sampler's Jacobian against central differences of its velocity with the given step.
void expect_consistent_jacobian(const VectorField& field, const Vec3& x, double t, double step,
                                double tolerance);

/// A name that GoogleTest accepts.
std::string test_name(std::string_view name);

}  // namespace pellucid::fields
