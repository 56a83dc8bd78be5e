// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every kind of file that a sampled field is read from.

#include <gmock/gmock.h>

#include <random>
#include <thread>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {
namespace {

const Mat3 slope(0.5, -1, 2, 0.25, 3, -0.5, 1, 0.75, -2);

/// Every interpolant here reproduces it.
Vec3 affine(const Vec3& x) { return Vec3(1, -2, 3) + slope * x; }

class PropertySampled : public ::testing::TestWithParam<GridKind> {
 protected:
  std::unique_ptr<VectorField> make(const Velocity& velocity, const std::string& options = "") {
    return make_field(write_grid(folder_, GetParam(), velocity).string() + options);
  }

  /// Rounding of the samples, of size 10; in general hexahedra what VTK's Newton iterations leave.
  double tolerance() const {
    if (GetParam().single_precision) return 4e-6;
    return is_curvilinear() ? 1e-9 : 1e-12;
  }
  bool is_curvilinear() const {
    return GetParam().name == "vts" || GetParam().name == "legacy_structured";
  }

  TemporaryFolder folder_;
};

std::vector<Vec3> random_points(std::size_t count) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> fraction(0, 1);
  std::vector<Vec3> points(count);
  for (Vec3& x : points)
    x = grid_box.min +
        (grid_box.max - grid_box.min) * Vec3(fraction(random), fraction(random), fraction(random));
  return points;
}

TEST_P(PropertySampled, ReproducesAnAffineField) {
  const auto field = make(affine);
  const auto sampler = field->sampler();
  for (const Vec3& x : random_points(300)) {
    Vec3 v;
    Mat3 jacobian;
    ASSERT_EQ(sampler->velocity(x, 0, v), SampleStatus::ok) << text_of(x);
    EXPECT_NEAR_VEC(v, affine(x), tolerance());
    ASSERT_EQ(sampler->velocity_and_jacobian(x, 0, v, jacobian), SampleStatus::ok);
    EXPECT_NEAR_VEC(v, affine(x), tolerance());
    EXPECT_LE(norm(jacobian - slope), 10 * tolerance());  // divided by a cell's width
  }
}

TEST_P(PropertySampled, TheJacobianIsThatOfTheInterpolant) {
  const auto field = make(
      [](const Vec3& x) { return Vec3(std::sin(x.x * x.y), x.z * x.y, std::cos(x.x + 2 * x.z)); });
  // The stencils of these points cross no face of a cell, which the fixed seed decides. Newton's
  // iterations leave 1e-9 in curvilinear cells, which a step divides.
  const double step = is_curvilinear() ? 1e-4 : 1e-6;
  for (const Vec3& x : random_points(100)) expect_consistent_jacobian(*field, x, 0, step, step);
}

TEST_P(PropertySampled, EndsAtTheLastSample) {
  const auto field = make(affine);
  const Vec3 middle = grid_box.center();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3 edge = middle;
      edge[axis] = side < 0 ? grid_box.min[axis] : grid_box.max[axis];
      Vec3 beyond = edge;
      beyond[axis] += side * 0.01;
      EXPECT_NEAR_VEC(velocity_of(*field, edge), affine(edge), tolerance());
      EXPECT_EQ(status_at(*field, beyond), SampleStatus::outside) << text_of(beyond);
    }
  EXPECT_EQ(status_at(*field, Vec3(std::nan(""))), SampleStatus::outside);
  EXPECT_EQ(status_at(*field, Vec3(1e300)), SampleStatus::outside);
}

TEST_P(PropertySampled, CornersBelongToIt) {
  const auto field = make(affine);
  for (const Vec3& corner : {grid_box.min, grid_box.max}) {
    EXPECT_NEAR_VEC(velocity_of(*field, corner), affine(corner), tolerance());
    Vec3 v;
    Mat3 jacobian;
    ASSERT_EQ(field->sampler()->velocity_and_jacobian(corner, 0, v, jacobian), SampleStatus::ok);
    EXPECT_LE(norm(jacobian - slope), 10 * tolerance());
  }
}

TEST_P(PropertySampled, TellsItsSize) {
  const auto field = make(affine);
  if (GetParam().name != "vdb_sparse") {  // which has a voxel elsewhere
    EXPECT_NEAR_VEC(field->domain().min, grid_box.min, 1e-12);
    EXPECT_NEAR_VEC(field->domain().max, grid_box.max, 1e-12);
  }
  ASSERT_TRUE(field->cell_size().has_value());
  EXPECT_GT(*field->cell_size(), 0.2);  // the axes' 0.4 … 0.5, bent by 30 %
  EXPECT_LT(*field->cell_size(), 0.6);
  EXPECT_TRUE(field->steady());
  EXPECT_THAT(field->description(), ::testing::StartsWith(GetParam().name));
  ASSERT_TRUE(field->sampling_error().has_value());
  EXPECT_LE(*field->sampling_error(), tolerance());
}

TEST_P(PropertySampled, NonFiniteSamplesAreAStatusAroundThemAlone) {
  if (GetParam().ending != ".vdb" && !GetParam().name.ends_with("appended") &&
      GetParam().name != "legacy_image" && GetParam().name != "mha")
    return;  // text formats have no word for it
  const auto field = make([](const Vec3& x) {
    return glm::length(x - grid_box.min) < 1e-9 ? Vec3(std::nan("")) : affine(x);
  });
  EXPECT_EQ(status_at(*field, grid_box.min + 0.01), SampleStatus::not_finite);
  EXPECT_EQ(status_at(*field, grid_box.max - 0.01), SampleStatus::ok);
}

TEST_P(PropertySampled, SamplersOfSeveralThreadsAgree) {
  const auto field = make([](const Vec3& x) { return Vec3(std::sin(3 * x.x), x.y * x.z, x.x); });
  const std::vector<Vec3> points = random_points(500);
  std::vector<std::vector<Vec3>> results(4, std::vector<Vec3>(points.size()));
  {
    std::vector<std::jthread> threads;
    for (std::vector<Vec3>& result : results)
      threads.emplace_back([&] {
        const auto sampler = field->sampler();
        for (std::size_t i = 0; i < points.size(); ++i) sampler->velocity(points[i], 0, result[i]);
      });
  }
  for (const std::vector<Vec3>& result : results) EXPECT_EQ(result, results.front());
}

TEST_P(PropertySampled, OnlyGridsWithAxesTakeC1) {
  const auto path = write_grid(folder_, GetParam(), affine).string() + ":sampler=c1";
  if (!GetParam().takes_c1) {
    EXPECT_THAT([&] { make_field(path); },
                ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("sampler=linear")));
    return;
  }
  const auto field = make_field(path);
  for (const Vec3& x : random_points(50))
    EXPECT_NEAR_VEC(velocity_of(*field, x), affine(x), tolerance());
}

INSTANTIATE_TEST_SUITE_P(, PropertySampled, ::testing::ValuesIn(grid_kinds()),
                         [](const auto& kind) { return test_name(kind.param.name); });

}  // namespace
}  // namespace pellucid::fields
