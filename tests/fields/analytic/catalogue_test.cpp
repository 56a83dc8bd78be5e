// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/analytic/catalogue.h"

#include <gmock/gmock.h>

#include <random>

#include "fields/analytic/analytic_field.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"

namespace pellucid::fields {

/// How GoogleTest names a row.
void PrintTo(const FieldRow& row, std::ostream* out) { *out << row.name; }

namespace {

// The constants are written with 17 digits and every formula has a few operations on numbers of
// size 1.
constexpr double rounding = 1e-14;

TEST(UnitCatalogue, AbcIsItsFormula) {
  const Vec3 x(0.3, 1.1, -0.7);
  const double A = std::sqrt(3.0), B = std::sqrt(2.0), C = 1;
  const Vec3 expected(A * std::sin(x.z) + C * std::cos(x.y), B * std::sin(x.x) + A * std::cos(x.z),
                      C * std::sin(x.y) + B * std::cos(x.x));
  EXPECT_NEAR_VEC(velocity_of("abc", x), expected, rounding);
  EXPECT_NEAR_VEC(velocity_of("abc:A=0,B=0,C=2", x), Vec3(2 * std::cos(1.1), 0, 2 * std::sin(1.1)),
                  rounding);
}

TEST(UnitCatalogue, AbcDecaysAsViscosityWouldHaveIt) {
  const Vec3 x(0.3, 1.1, -0.7);
  EXPECT_NEAR_VEC(velocity_of("abc:decay=0.5", x, 2.0), std::exp(-1.0) * velocity_of("abc", x),
                  rounding);
  EXPECT_TRUE(make_field("abc")->steady());
  EXPECT_FALSE(make_field("abc:decay=0.5")->steady());
}

TEST(UnitCatalogue, LinearFlowsAreTheirFormulas) {
  const Vec3 x(0.5, -2, 7);
  EXPECT_EQ(velocity_of("rotation:omega=2,c=-1", x), Vec3(4, 1, -1));
  EXPECT_EQ(velocity_of("saddle:a=3", x), Vec3(1.5, 6, 0));
  EXPECT_EQ(velocity_of("shear:b=0.25", x), Vec3(-1.75, 0, 0));
}

// Values of the published program, its text compiled with double for float: on the funnel's wall
// without and with updraught, and far outside.
TEST(UnitCatalogue, TornadoIsThePublishedProgram) {
  EXPECT_NEAR_VEC(velocity_of("tornado", {0.25, 0.75, 0.5}, 0),
                  Vec3(0.054662234044876246, 0.068745531953037772, 0), rounding);
  EXPECT_NEAR_VEC(velocity_of("tornado", {0.5, 0.5, 0.25}, 7),
                  Vec3(-0.2095341873530899, 0.12132965272821844, 0.029867107290730978), rounding);
  EXPECT_NEAR_VEC(velocity_of("tornado", {1, 0, 0.125}, 7),
                  Vec3(0.09804606818912504, -0.018534114174420552, -0.00011517904529283662),
                  rounding);
}

TEST(UnitCatalogue, TornadoEndsWhereItWasPublished) {
  const auto sampler = make_field("tornado")->sampler();
  Vec3 v;
  EXPECT_EQ(sampler->velocity({1, 1, 1}, 0, v), SampleStatus::ok);
  EXPECT_EQ(sampler->velocity({1, 1, 1 + 1e-12}, 0, v), SampleStatus::outside);
  EXPECT_EQ(sampler->velocity({std::nan(""), 0, 0}, 0, v), SampleStatus::outside);
}

class PropertyCatalogue : public ::testing::TestWithParam<FieldRow> {
 protected:
  /// Points of the row's region, kept off its faces so that a stencil stays inside.
  std::vector<Vec3> points() const {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> fraction(0.01, 0.99);
    std::vector<Vec3> points(200);
    const Box3& box = GetParam().region;
    for (Vec3& x : points)
      x = box.min +
          (box.max - box.min) * Vec3(fraction(random), fraction(random), fraction(random));
    return points;
  }
};

// A step of 1e-6 leaves rounding of 1e-10 times the velocity and truncation of 1e-12 times the
// third derivative, which reaches 1e5 in the cores of vortices.
TEST_P(PropertyCatalogue, TheJacobianIsThatOfTheVelocity) {
  const auto field = make_field(GetParam().name);
  for (const Vec3& x : points()) expect_consistent_jacobian(*field, x, 0.6, 1e-6, 1e-6);
}

TEST_P(PropertyCatalogue, KeepsItsPromises) {
  const auto field = make_field(GetParam().name);
  const auto sampler = field->sampler();
  EXPECT_EQ(field->steady(), GetParam().steady);
  for (const Vec3& x : points()) {
    Vec3 now, later;
    Mat3 jacobian;
    ASSERT_EQ(sampler->velocity_and_jacobian(x, 0, now, jacobian), SampleStatus::ok);
    ASSERT_EQ(sampler->velocity(x, 1.5, later), SampleStatus::ok);
    EXPECT_EQ(now == later, GetParam().steady);
    if (!GetParam().divergence_free) continue;
    EXPECT_NEAR(divergence(jacobian), 0, 1e-12 * (1 + norm(jacobian)));  // rounding alone
  }
}

TEST_P(PropertyCatalogue, TellsWhatItIs) {
  EXPECT_FALSE(GetParam().title.empty());
  EXPECT_FALSE(GetParam().citation.empty());
  EXPECT_FALSE(GetParam().formula.empty());
  EXPECT_FALSE(GetParam().region.empty());
  EXPECT_THAT(make_field(GetParam().name)->description(), ::testing::StartsWith(GetParam().name));
  for (const ParameterSpec& spec : GetParam().parameters) EXPECT_FALSE(spec.unit.empty());
}

INSTANTIATE_TEST_SUITE_P(, PropertyCatalogue, ::testing::ValuesIn(analytic_fields()),
                         [](const auto& row) { return test_name(row.param.name); });

}  // namespace
}  // namespace pellucid::fields
