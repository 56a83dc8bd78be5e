// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/integrate_lines.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/integrators/lines/trajectory_error.h"

namespace pellucid::integrators {
namespace {

LineRequest request_for(const fields::VectorField& field, double duration) {
  LineRequest request;
  request.field = &field;
  request.seeds = seeds_on(segment_seed({0.2, 1, 0}, {1, 1, 0.3}), 7);
  request.duration = duration;
  return request;
}

TEST(UnitLines, StreamLinesOfTheSaddleAreHyperbolas) {
  const auto field = fields::make_field("saddle");
  const LineRequest request = request_for(*field, 2);
  const geometry::LineSet lines = integrate_lines("stream-lines", request).lines;
  ASSERT_EQ(lines.line_count(), 7u);
  for (std::size_t k = 0; k < 7; ++k) {
    EXPECT_EQ(lines.positions[lines.offsets[k]], request.seeds[k]);
    EXPECT_EQ(lines.scalars.at("t")[lines.offsets[k + 1] - 1], 2);
    for (std::size_t i = lines.offsets[k]; i < lines.offsets[k + 1]; ++i)
      EXPECT_NEAR(lines.positions[i].x * lines.positions[i].y, request.seeds[k].x,
                  trajectory_error);
  }
}

TEST(UnitLines, PathAndStreamAndStreakDifferInAnUnsteadyField) {
  // v = (cos t, sin t, 0): stream lines at time 0 are straight, path lines circles that start along
  // x; the streak line from x₀ at time T joins x₀ + ∫ v from T - age to T.
  const auto field = fields::make_field("drift");
  LineRequest request = request_for(*field, 2);
  request.seeds = {{0, 0, 0}};
  for (const Vec3& x : integrate_lines("stream-lines", request).lines.positions)
    // sin 0 is 0: nothing moves along y.
    EXPECT_EQ(x.y, 0);
  const geometry::LineSet paths = integrate_lines("path-lines", request).lines;
  for (std::size_t i = 0; i < paths.positions.size(); ++i) {
    const double t = paths.scalars.at("t")[i];
    EXPECT_LE(glm::distance(paths.positions[i], Vec3(std::sin(t), 1 - std::cos(t), 0)),
              trajectory_error);
  }
  const geometry::LineSet streaks = integrate_lines("streak-lines:releases=40", request).lines;
  ASSERT_EQ(streaks.positions.size(), 41u);
  for (std::size_t i = 0; i < streaks.positions.size(); ++i) {
    const double begin = 2 - streaks.scalars.at("t")[i];
    const Vec3 expected(std::sin(2) - std::sin(begin), std::cos(begin) - std::cos(2), 0);
    EXPECT_LE(glm::distance(streaks.positions[i], expected), trajectory_error);
  }
}

TEST(UnitLines, VerticesKeepTheirDistance) {
  const auto field = fields::make_field("rotation");
  const LineRequest request = request_for(*field, 3);
  const geometry::LineSet lines = integrate_lines("stream-lines:step=0.05", request).lines;
  for (std::size_t i = 1; i < lines.positions.size(); ++i) {
    const bool begins = lines.scalars.at("t")[i] == 0;
    const double apart = glm::distance(lines.positions[i], lines.positions[i - 1]);
    EXPECT_TRUE(begins || apart <= 0.05 + 1e-9) << apart;
  }
}

TEST(UnitLines, VerticesKeepTheirDistanceWhereTheFlowSpeedsUp) {
  const auto field = fields::make_field("formula:u=1+5*(tanh(20*(x-1))+1),v=0,w=0");
  LineRequest request = request_for(*field, 2);
  request.seeds = {{0, 0, 0}};
  const auto& x = integrate_lines("stream-lines:step=0.1", request).lines.positions;
  for (std::size_t i = 1; i < x.size(); ++i)
    EXPECT_LE(glm::distance(x[i], x[i - 1]), 0.1 + 1e-6) << i;
}

/// Straight up to x = 1, and in waves from there on.
TEST(UnitLines, TurnNoFartherWhereTheFlowBendsOnTheWay) {
  const auto field = fields::make_field("formula:u=1,v=max(0,x-1)*3*cos(6*x),w=0");
  LineRequest request = request_for(*field, 4);
  request.seeds = {{0, 0, 0}};
  const auto& x = integrate_lines("stream-lines:turn=3", request).lines.positions;
  for (std::size_t i = 2; i < x.size(); ++i) {
    const Vec3 before = glm::normalize(x[i - 1] - x[i - 2]);
    const Vec3 after = glm::normalize(x[i] - x[i - 1]);
    // A chord's direction is one of its way's, which turns by 3 degrees.
    constexpr double most = 2 * 3.01 * std::numbers::pi / 180;
    EXPECT_LE(std::acos(std::min(1.0, glm::dot(before, after))), most) << i;
  }
}

TEST(PropertyLines, TheSameToTheLastBitForAnyNumberOfThreads) {
  const auto field = fields::make_field("abc");
  for (const LineIntegratorRow& row : line_integrators()) {
    LineRequest request = request_for(*field, 3);
    request.seeds = seeds_in({{0, 0, 0}, {6, 6, 6}}, 4, 3, 2);
    const geometry::LineSet parallel = integrate_lines(row.name, request).lines;
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const geometry::LineSet serial = integrate_lines(row.name, request).lines;
    EXPECT_EQ(parallel.positions, serial.positions) << row.name;
    EXPECT_EQ(parallel.offsets, serial.offsets) << row.name;
    EXPECT_EQ(parallel.scalars, serial.scalars) << row.name;
  }
}

TEST(UnitLines, SeedsFillCurvesAndBoxes) {
  const auto grid = seeds_in({{0, 0, 0}, {1, 2, 3}}, 2, 3, 1);
  ASSERT_EQ(grid.size(), 6u);
  EXPECT_EQ(grid.front(), Vec3(0, 0, 1.5));
  EXPECT_EQ(grid.back(), Vec3(1, 2, 1.5));
  EXPECT_EQ(seeds_on(circle_seed({0, 0, 0}, {0, 0, 1}, 1), 4).size(), 4u);
}

TEST(UnitLines, WrongCallsAreRefused) {
  const auto field = fields::make_field("abc");
  LineRequest request = request_for(*field, 1);
  EXPECT_THROW(integrate_lines("steam-lines", request), InputError);
  EXPECT_THROW(integrate_lines("stream-lines:step=0", request), InputError);
  request.duration = 0;
  EXPECT_THROW(integrate_lines("stream-lines", request), InputError);
  request.seeds.clear();
  EXPECT_THROW(integrate_lines("stream-lines", request), InputError);
}

}  // namespace
}  // namespace pellucid::integrators
