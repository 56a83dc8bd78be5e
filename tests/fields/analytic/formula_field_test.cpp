// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/analytic/formula_field.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"

namespace pellucid::fields {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

auto making(std::string_view text) {
  return [text] { make_field(text); };
}

auto complains_of(const std::string& what) { return ThrowsMessage<InputError>(HasSubstr(what)); }

TEST(UnitFormula, EvaluatesOverPositionAndTime) {
  EXPECT_EQ(velocity_of("formula:u=-y,v=x,w=0.2", {3, 4, 5}), Vec3(-4, 3, 0.2));
  EXPECT_EQ(velocity_of("formula:u=z*t,v=max(x,y),w=t^2", {3, 4, 5}, 2), Vec3(10, 4, 4));
  EXPECT_NEAR_VEC(velocity_of("formula:u=sin(pi/2),v=ln(e),w=x<4 ? 1 : 2", {3, 4, 5}),
                  Vec3(1, 1, 1), 1e-15);
}

TEST(UnitFormula, IsSteadyWithoutTime) {
  EXPECT_TRUE(make_field("formula:u=y,v=atan2(x,1),w=0")->steady());
  EXPECT_FALSE(make_field("formula:u=y,v=x,w=sin(t)")->steady());
}

TEST(UnitFormula, SaysWhatItIs) {
  EXPECT_EQ(make_field("formula:w=0.2,u=-y,v=x")->description(), "formula:u=-y,v=x,w=0.2");
}

TEST(UnitFormula, NamesTheComponentAndTheColumn) {
  EXPECT_THAT(making("formula:u=-y,v=x+q,w=0"),
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("v=x+q"), HasSubstr("column 3"), HasSubstr("\"q\""))));
  EXPECT_THAT(making("formula:u=-y,v=x,w=2*(x"), complains_of("w=2*(x: column 6"));
  EXPECT_THAT(making("formula:u=1 1,v=x,w=0"), complains_of("u=1 1: column 3"));
  EXPECT_THAT(making("formula:u=sin(),v=x,w=0"), complains_of("u=sin(): column 5"));
}

TEST(UnitFormula, AllThreeComponentsAreNeeded) {
  EXPECT_THAT(making("formula:u=-y,w=0"), complains_of("v= is missing"));
  EXPECT_THAT(making("formula:u=-y,v=,w=0"), complains_of("v= is missing"));
  EXPECT_THAT(making("formula"), complains_of("u= is missing"));
  EXPECT_THAT(making("formula:u=1,v=2,w=3,q=4"), complains_of("unknown key 'q'; known: u, v, w"));
}

TEST(UnitFormula, MayNotAssign) {
  EXPECT_THAT(making("formula:u=(x=3),v=x,w=0"), complains_of("column 3: '=' assigns"));
  EXPECT_EQ(velocity_of("formula:u=x==3,v=x<=3,w=x!=3", {3, 0, 0}), Vec3(1, 1, 0));
}

TEST(UnitFormula, NonFiniteValuesAreAStatus) {
  EXPECT_EQ(status_at(*make_field("formula:u=1/x,v=0,w=0"), {0, 1, 1}), SampleStatus::not_finite);
  EXPECT_EQ(status_at(*make_field("formula:u=0,v=sqrt(y),w=0"), {0, -1, 1}),
            SampleStatus::not_finite);
  EXPECT_EQ(status_at(*make_field("formula:u=0,v=sqrt(y),w=0"), {0, 1, 1}), SampleStatus::ok);
}

// Fourth order with step ε^(1/5): rounding ε/h and truncation h⁴ are both near 1e-12 for a function
// whose derivatives are of size 1.
TEST(PropertyFormula, TheJacobianIsThatOfTheFormula) {
  const auto sampler = make_field("formula:u=sin(x)*y,v=exp(z)*cos(t),w=x*y*z + x^3")->sampler();
  const Vec3 x(0.4, -1.2, 0.9);
  const double t = 0.7;
  Vec3 v;
  Mat3 jacobian;
  ASSERT_EQ(sampler->velocity_and_jacobian(x, t, v, jacobian), SampleStatus::ok);
  const Mat3 exact(std::cos(x.x) * x.y, 0, x.y * x.z + 3 * x.x * x.x,  //
                   std::sin(x.x), 0, x.x * x.z,                        //
                   0, std::exp(x.z) * std::cos(t), x.x * x.y);
  EXPECT_LE(norm(jacobian - exact), 2e-11);
}

/// Differences over a fixed length saw nothing of a flow in micrometres, or far from the origin. To
/// 1e-9 near it; far from it x itself is rounded to 2e-10 of the sine's argument.
TEST(PropertyFormula, TheJacobianIsThatOfTheFormulaAtAnyScale) {
  const auto near = make_field("formula:u=sin(x*1e6),v=0,w=0")->sampler();
  const auto far = make_field("formula:u=sin(x-4e6),v=0,w=0")->sampler();
  near->resolve(1e-6);
  far->resolve(1);
  Vec3 v;
  Mat3 jacobian;
  ASSERT_EQ(near->velocity_and_jacobian({0.4e-6, 0, 0}, 0, v, jacobian), SampleStatus::ok);
  EXPECT_NEAR(jacobian[0].x, 1e6 * std::cos(0.4), 1e-3);
  ASSERT_EQ(far->velocity_and_jacobian({4e6 + 0.4, 0, 0}, 0, v, jacobian), SampleStatus::ok);
  EXPECT_NEAR(jacobian[0].x, std::cos(0.4), 1e-8);
}

TEST(UnitFormula, HasAJacobianWhereverItHasAVelocity) {
  const auto sampler = make_field("formula:u=sqrt(z),v=0,w=0")->sampler();
  Vec3 v;
  Mat3 jacobian;
  ASSERT_EQ(sampler->velocity_and_jacobian({0, 0, 5e-4}, 0, v, jacobian), SampleStatus::ok);
  // A thousandth: the steps are as long as a part of the way to the edge, where the slope is
  // infinite.
  EXPECT_NEAR(jacobian[2].x, 0.5 / std::sqrt(5e-4), 2e-2);
}

TEST(AgreementFormula, EqualsTheCatalogue) {
  for (const Vec3& x : {Vec3(0.1, 0.2, 0.3), Vec3(-4, 7, 2)})
    EXPECT_NEAR_VEC(velocity_of("formula:u=sqrt(3)*sin(z)+cos(y),v=sqrt(2)*sin(x)+sqrt(3)*cos(z),"
                                "w=sin(y)+sqrt(2)*cos(x)",
                                x),
                    velocity_of("abc", x), 1e-14);
}

}  // namespace
}  // namespace pellucid::fields
