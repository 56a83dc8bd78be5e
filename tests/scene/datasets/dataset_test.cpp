// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/datasets/dataset.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "core/error.h"
#include "scene/datasets/stack.h"

namespace pellucid::scene {
namespace {

/// Of a data set that is a shape.
const geometry::Vertices& vertices(const Dataset& data) {
  if (const auto* mesh = std::get_if<geometry::TriangleMesh>(&data)) return *mesh;
  if (const auto* lines = std::get_if<geometry::LineSet>(&data)) return *lines;
  return std::get<geometry::PointSet>(data);
}

void expect_same_shape(const Dataset& a, const Dataset& b) {
  EXPECT_FALSE(vertices(a).positions.empty());
  EXPECT_TRUE(vertices(a).positions == vertices(b).positions);
  EXPECT_TRUE(vertices(a).importance == vertices(b).importance);
}

void expect_same_levels(const VelocityLevels& a, const VelocityLevels& b) {
  ASSERT_FALSE(a.empty());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].samples == b[i].samples);
}

/// "NAME", or "NAME:count=N" where there is such a parameter.
std::string small(const DatasetRow& row, int count, const std::string& more = {}) {
  const auto has_count = [](const ParameterSpec& spec) { return spec.name == "count"; };
  if (std::ranges::none_of(row.parameters, has_count)) return std::string(row.name);
  return std::string(row.name) + ":count=" + std::to_string(count) + more;
}

// One thread and many: a data set is a function of its parameters alone.
TEST(PropertyDataset, EveryRowMakesTheSameDataForAnyNumberOfThreads) {
  for (const DatasetRow& row : datasets()) {
    const std::string name = small(row, 3);
    const Dataset many = make_dataset(name);
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    const Dataset one = make_dataset(name);
    SCOPED_TRACE(row.name);
    if (row.on_levels)
      expect_same_levels(std::get<VelocityLevels>(many), std::get<VelocityLevels>(one));
    else
      expect_same_shape(many, one);
    EXPECT_NE(row.citation, "") << row.name;
  }
}

TEST(PropertyDataset, AnotherSeedMakesOtherData) {
  for (const DatasetRow& row : datasets()) {
    if (small(row, 3) == row.name) continue;
    const Dataset one = make_dataset(small(row, 3)), two = make_dataset(small(row, 3, ",seed=2"));
    EXPECT_FALSE(vertices(one).positions == vertices(two).positions) << row.name;
  }
}

// What is important is a small part of it, and some of it is wholly so.
TEST(PropertyDataset, StandInsHaveImportanceInTheUnitInterval) {
  for (const DatasetRow& row : datasets()) {
    const bool surfaces = row.name == "tornado" || row.name == "delta-wing";
    if (small(row, 3) == row.name) continue;
    const Dataset data = make_dataset(small(row, surfaces ? 2 : 400));
    const std::vector<float>& g = vertices(data).importance;
    ASSERT_EQ(g.size(), vertices(data).positions.size()) << row.name;
    double sum = 0;
    for (const float x : g) {
      ASSERT_TRUE(x >= 0 && x <= 1) << row.name;
      sum += x;
    }
    EXPECT_EQ(*std::ranges::max_element(g), 1) << row.name;
    EXPECT_LT(sum / double(g.size()), 0.5) << row.name;
  }
}

TEST(UnitDataset, PointsAreAsManyAsAsked) {
  for (const char* name : {"dark-sky", "ctbl", "viscous-fingers"})
    EXPECT_EQ(vertices(make_dataset(std::string(name) + ":count=1234")).positions.size(), 1234u);
}

// The twelve atoms lie on two circles around the z axis, the ring of carbons and that of hydrogens.
// A tenth of the vertices, the nearest, are wholly important, and the farther six tenths not at
// all.
TEST(UnitDataset, BenzeneIsImportantAtItsAtoms) {
  const Dataset data = make_dataset("benzene:count=2000");
  const geometry::Vertices& lines = vertices(data);
  int near = 0;
  for (std::size_t i = 0; i < lines.positions.size(); ++i) {
    double distance = 10;
    for (int k = 0; k < 6; ++k)
      for (const double radius : {1.39, 2.48}) {
        const double angle = k * std::numbers::pi / 3;
        const Vec3 atom(radius * std::cos(angle), radius * std::sin(angle), 0);
        distance = std::min(distance, glm::distance(lines.positions[i], atom));
      }
    near += distance < 0.1;
    if (distance < 0.1) {
      EXPECT_GT(lines.importance[i], 0.8f) << distance;
    } else if (distance > 1.5) {
      EXPECT_EQ(lines.importance[i], 0) << distance;
    }
  }
  EXPECT_GT(near, 100);
}

TEST(UnitDataset, TornadosParticlesAreInTheFunnel) {
  const Dataset data = make_dataset("tornado-particles:count=200");
  ASSERT_EQ(vertices(data).positions.size(), 200u);
  for (const Vec3& x : vertices(data).positions) {
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(x, Vec3(0))));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(x, Vec3(1))));
  }
}

// The winds move on spheres: a line's radius is that of its seed up to the integrator's error.
TEST(UnitDataset, WindsStayOnTheirSphere) {
  const auto lines = std::get<geometry::LineSet>(make_dataset("ecmwf:count=20"));
  for (std::size_t k = 0; k < lines.line_count(); ++k)
    for (std::size_t i = lines.offsets[k]; i < lines.offsets[k + 1]; ++i)
      EXPECT_NEAR(glm::length(lines.positions[i]), glm::length(lines.positions[lines.offsets[k]]),
                  5e-5);  // measured 5e-6 of some 1; ten times that
}

TEST(UnitDataset, UnknownNamesAndValuesAreRefused) {
  EXPECT_THROW(make_dataset("stak"), InputError);
  EXPECT_THROW(make_dataset("stack:layers=0"), InputError);
}

/// The sheets' depths, in the order in which they are drawn.
std::vector<double> depths(const std::string& options) {
  const auto mesh = std::get<geometry::TriangleMesh>(make_dataset("stack:" + options));
  std::vector<double> z;
  for (std::size_t i = 0; i < mesh.positions.size(); i += 4) z.push_back(mesh.positions[i].z);
  return z;
}

TEST(UnitStack, SheetsLieWhereTheirParametersSay) {
  EXPECT_EQ(depths("layers=3,order=front"), (std::vector<double>{1, 0, -1}));
  EXPECT_EQ(depths("layers=3,order=back,scale=10,shift=5"), (std::vector<double>{-5, 5, 15}));
  EXPECT_EQ(depths("layers=2,depths=equal"), (std::vector<double>{0, 0}));
  const std::vector<double> close = depths("layers=3,depths=ulp,order=front");
  EXPECT_EQ(close[1], std::nextafter(1.0, 0.0));
  EXPECT_EQ(close[2], std::nextafter(close[1], 0.0));
  std::vector<double> shuffled = depths("layers=50");
  EXPECT_FALSE(std::is_sorted(shuffled.begin(), shuffled.end()));
  std::sort(shuffled.begin(), shuffled.end());
  std::vector<double> even = depths("layers=50,order=back");
  EXPECT_EQ(shuffled, even);
}

TEST(UnitStack, EverySheetCoversTheSquareOnce) {
  for (const char* sheet : {"square", "grid", "needles"}) {
    const auto mesh = std::get<geometry::TriangleMesh>(
        make_dataset(std::string("stack:layers=1,sheet=") + sheet));
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Vec3 n =
          glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
      EXPECT_GE(n.z, 0) << sheet;  // none is turned, so that none lies on another
      area += n.z / 2;
    }
    EXPECT_NEAR(area, 16, 1e-12) << sheet;
  }
}

}  // namespace
}  // namespace pellucid::scene
