// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles on isosurfaces: closed forms of a plane and a sphere, across a jump of resolution.

#include "fields/levels/surface_extraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "core/error.h"
#include "tests/support/levels.h"
#include "tests/support/mesh_area.h"

namespace pellucid::fields {
namespace {

using testing::sampled;

class PropertyExtraction : public ::testing::TestWithParam<ReconstructionRow> {};
INSTANTIATE_TEST_SUITE_P(All, PropertyExtraction, ::testing::ValuesIn(reconstructions),
                         [](const auto& row) { return std::string(row.param.name); });

TEST_P(PropertyExtraction, VerticesLieOnTheSurfaceOfTheReconstruction) {
  const auto distance = [](const Vec3& x) { return glm::length(x - 4.0); };
  const LevelField field({sampled(Vec3(0), 0.5, 17, distance), sampled(Vec3(3), 0.25, 9, distance)},
                         GetParam());
  const ExtractedSurface surface = extract_surface(field, 1.5);
  ASSERT_GT(surface.triangles.size(), 900u);
  std::size_t off = 0;
  for (std::size_t i = 0; i < surface.positions.size(); ++i)
    off += std::abs(field.value(surface.positions[i]).value() - 1.5) > 1e-9;
  // Newton's method has no answer where the reconstruction jumps across the value, and may not
  // reach it over a kink.
  EXPECT_LE(off, surface.positions.size() / (GetParam().continuous ? 50 : 20));
}

TEST(UnitExtraction, ASphereHasItsAreaAndIsClosed) {
  const auto distance = [](const Vec3& x) { return glm::length(x - 4.0); };
  double before = 0;
  for (const int n : {17, 33, 65}) {
    const LevelField field({sampled(Vec3(0), 8.0 / (n - 1), n, distance)},
                           find_reconstruction("trilinear"));
    const ExtractedSurface surface = extract_surface(field, 2.9);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (const auto& t : surface.triangles)
      for (int k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    for (const auto& [edge, count] : edges) ASSERT_EQ(count, 2);
    const double error = std::abs(testing::area_of(surface) - 4 * std::numbers::pi * 2.9 * 2.9);
    if (before > 0) {
      EXPECT_LT(error, before / 3);  // order 2: a quarter
    }
    before = error;
    for (std::size_t i = 0; i < surface.positions.size(); ++i)
      EXPECT_GT(glm::dot(surface.normals[i], glm::normalize(surface.positions[i] - 4.0)), 0.95);
  }
}

TEST(UnitExtraction, IsOpenAtTheFieldsEnd) {
  // The plane x = 1.3 across two boxes side by side of different height: 2 × 2 and 1 × 2.
  const auto x = [](const Vec3& p) { return p.x; };
  const ScalarLevel tall = sampled(Vec3(0), 0.25, {9, 9, 9}, x);
  const ScalarLevel low = sampled(Vec3(0, 2.5, 0), 0.25, {9, 5, 9}, x);
  const LevelField field({tall, low}, find_reconstruction("trilinear"));
  const ExtractedSurface surface = extract_surface(field, 1.3);
  // Between the boxes, from 2 to 2.5, there is no field. A place on the upper face of the taller
  // one belongs to what lies above: the last of its cells, 0.25 wide, has no corners there.
  EXPECT_NEAR(testing::area_of(surface), 2 * (2 - 0.25) + 2 * 1, 1e-5);
  for (const auto& t : surface.triangles)
    for (const std::uint32_t corner : t) EXPECT_NEAR(surface.positions[corner].x, 1.3, 1e-6);
}

TEST(UnitExtraction, RefusesMoreSamplesThanItCanHold) {
  const auto one = [](const Vec3&) { return 1.0; };
  const LevelField field({sampled(Vec3(0), 1, 9, one), sampled(Vec3(4), 1e-3, 3, one)},
                         find_reconstruction("trilinear"));
  EXPECT_THROW(extract_surface(field, 0.5), InputError);
}

TEST(UnitExtraction, ValuesOutOfRangeHaveNoTriangle) {
  const LevelField field({sampled(Vec3(0), 1, 5, [](const Vec3& x) { return x.x; })},
                         find_reconstruction("blend"));
  EXPECT_TRUE(extract_surface(field, 9).triangles.empty());
}

}  // namespace
}  // namespace pellucid::fields
