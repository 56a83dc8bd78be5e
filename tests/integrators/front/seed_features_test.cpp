// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/front/seed_features.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>

#include "fields/make_field.h"
#include "fields/sampled/dense_field.h"
#include "integrators/mesh/mesh_quality.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"
#include "tests/support/mesh_area.h"

namespace pellucid::integrators {
namespace {

using ::testing::IsEmpty;

SurfaceRequest request_of(const fields::VectorField& field, double from, double to,
                          double duration) {
  SurfaceRequest request;
  request.field = &field;
  request.seed = segment_seed({0, from, 0}, {0, to, 0});
  request.duration = duration;
  return request;
}

std::vector<double> features_of(const fields::VectorField& field, std::span<const double> seeds) {
  const SurfaceRequest request = request_of(field, 0, 1, 1);
  return seed_features(request, surface_setup(request, SurfaceOptions{}), seeds).seeds;
}

TEST(UnitSeedFeatures, ALinearFieldHasNone) {
  const auto field = fields::make_field("formula:u=1+y,v=0,w=2*y");
  const std::vector<double> seeds{0, 0.5, 1};
  EXPECT_THAT(features_of(*field, seeds), IsEmpty());
}

TEST(UnitSeedFeatures, ABumpBetweenTheSeedsIsFound) {
  const auto field = fields::make_field("formula:u=1,v=0,w=2*exp(-((y-0.3)*50)^2)");
  const std::vector<double> seeds{0, 0.5, 1};
  const std::vector<double> features = features_of(*field, seeds);
  ASSERT_FALSE(features.empty());
  EXPECT_TRUE(std::ranges::is_sorted(features));
  for (const double s : features) EXPECT_NEAR(s, 0.3, 3. / 50);  // 3 widths of the bump
  const bool at_top =
      std::ranges::any_of(features, [](double s) { return std::abs(s - 0.3) <= 1. / seed_looks; });
  EXPECT_TRUE(at_top);
}

/// Four particles miss the bump: what is measured from the mesh says nothing of it, what is
/// measured from the surface does.
TEST(UnitSeedFeatures, TheMeasureOfErrorSeesWhatAMeshSteppedOver) {
  const auto field = fields::make_field("formula:u=1,v=0,w=2*exp(-((y-0.5)*50)^2)");
  const SurfaceRequest request = request_of(*field, 0, 1, 1);
  const auto surface = integrate_surface("fixed-front:particles=4", request);
  const SurfaceError error = measure_error(surface.mesh, request);
  EXPECT_NEAR(error.max_from_surface, 2, 0.1);  // 400 seeds: one is within 1/800 of the bump's top
  const auto fine = integrate_surface("fixed-front:particles=2000", request);
  EXPECT_LT(measure_error(fine.mesh, request).max_from_surface, 1e-3);  // h²/8 |w''|, w'' = 1e4
}

/// A uniform flow along x on samples over 0 ≤ x ≤ 4, 0 ≤ y ≤ 8, without those of low < y < high and
/// x ≥ from.
std::unique_ptr<fields::VectorField> with_hole(double low, double high, double from = 0) {
  std::vector<glm::vec3> samples;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 33; ++j)
      for (int i = 0; i < 9; ++i) {
        const bool hole = 0.25 * j > low && 0.25 * j < high && 0.5 * i >= from;
        samples.emplace_back(hole ? std::numeric_limits<float>::quiet_NaN() : 1.f, 0.f, 0.f);
      }
  fields::DenseGrid<glm::vec3> grid{
      {fields::Axis::uniform(0, 0.5, 9), fields::Axis::uniform(0, 0.25, 33),
       fields::Axis::uniform(0, 1, 3)},
      std::move(samples),
      std::nullopt};
  return fields::make_dense_field(std::move(grid), fields::Interpolation::linear, "hole");
}

class PropertySeedFeatures : public ::testing::TestWithParam<const char*> {};

/// The sheet z = w(y) t over 0 ≤ x ≤ 1: its highest point is that of the bump, wherever that is.
TEST_P(PropertySeedFeatures, NoSurfaceStepsOverABump) {
  for (const double center : {0.11, 0.25, 0.3, 0.42, 0.77, 0.99}) {
    const auto field =
        fields::make_field("formula:u=1,v=0,w=1+2*exp(-((y-" + std::to_string(center) + ")*60)^2)");
    const auto surface = integrate_surface(GetParam(), request_of(*field, 0, 1, 1));
    double highest = 0;
    for (const Vec3& x : surface.mesh.positions) highest = std::max(highest, x.z);
    // Looks are 1/1024 apart: the next one to the top misses it by 2 (60/2048)² at most.
    EXPECT_NEAR(highest, 3, 0.01) << GetParam() << ", bump at " << center;
  }
}

/// A seed curve across a hole: what the hole leaves is swept, and nothing spans it. The cells
/// beside missing samples are missing, too.
TEST_P(PropertySeedFeatures, NoSurfaceSpansAHole) {
  struct Hole {
    double low, high, left;
  };
  for (const auto& [low, high, left] :
       {Hole{3.2, 4.8, 7 - 2}, Hole{1.2, 1.8, 7 - 1}, Hole{6.2, 6.8, 7 - 1}}) {
    const auto field = with_hole(low, high);
    SurfaceRequest request = request_of(*field, 0.5, 7.5, 2);
    request.seed = segment_seed({1, 0.5, 1}, {1, 7.5, 1});
    const auto surface = integrate_surface(GetParam(), request);
    EXPECT_NEAR(testing::area_of(surface.mesh), 2 * left, 0.02 * 2 * left)
        << GetParam() << ", hole from " << low;
  }
}

/// Nothing along the seed curve tells of an obstacle downstream: from x = 2.5 on, a stretch of 1 of
/// the 7 is missing.
TEST_P(PropertySeedFeatures, NoSurfaceSpansAnObstacleDownstream) {
  const auto field = with_hole(1.2, 1.8, 3);
  SurfaceRequest request = request_of(*field, 0.5, 7.5, 2.75);
  request.seed = segment_seed({1, 0.5, 1}, {1, 7.5, 1});
  const auto surface = integrate_surface(GetParam(), request);
  const double right = 7 * 2.75 - 1 * (1 + 2.75 - 2.5);
  EXPECT_NEAR(testing::area_of(surface.mesh), right, 0.02 * right) << GetParam();
}

INSTANTIATE_TEST_SUITE_P(, PropertySeedFeatures,
                         ::testing::Values("hultquist:tolerance=0.01", "hultquist:threshold=0.2",
                                           "adaptive-front:tolerance=0.01",
                                           "adaptive-front:threshold=0.2"));

}  // namespace
}  // namespace pellucid::integrators
