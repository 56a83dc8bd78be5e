// SPDX-License-Identifier: GPL-3.0-or-later
// Lines have a budget of vertices, and ends at either end of what a double holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "core/error.h"
#include "fields/make_field.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/surfaces/integrate_surface.h"
#include "integrators/surfaces/surface_error.h"

namespace pellucid::integrators {
namespace {

IntegratedLines lines_in(const std::string& velocity, std::string_view integrator,
                         std::vector<Vec3> seeds, double duration, bool both = false) {
  const auto field = fields::make_field("formula:" + velocity);
  return integrate_lines(integrator, {field.get(), std::move(seeds), duration, 0, {}, both});
}

TEST(UnitLineBudget, EndsLinesThatWouldHaveMore) {
  const auto cut =
      lines_in("u=1,v=0,w=0", "stream-lines:step=1e-9,max-vertices=1000", {Vec3(0)}, 2);
  EXPECT_EQ(cut.lines.positions.size(), 1000u);
  EXPECT_EQ(cut.stats.ends, (EndCounts{{EndReason::vertices, 1}}));
  EXPECT_NEAR(cut.lines.positions.back().x, 999e-9, 1e-15);
  // A line of exactly as many is whole: its seed, and 20 steps of a 20th of the duration.
  const auto whole = lines_in("u=1,v=0,w=0", "stream-lines:max-vertices=21", {Vec3(0)}, 2);
  EXPECT_EQ(whole.lines.positions.size(), 21u);
  EXPECT_EQ(whole.stats.ends, (EndCounts{{EndReason::duration, 1}}));
  const auto both =
      lines_in("u=1,v=0,w=0", "stream-lines:step=1e-3,max-vertices=100", {Vec3(0)}, 2, true);
  EXPECT_EQ(both.lines.positions.size(), 99u);  // the seed is there once
  const auto streak =
      lines_in("u=1,v=0,w=0", "streak-lines:releases=500,max-vertices=50", {Vec3(0)}, 2);
  EXPECT_EQ(streak.lines.positions.size(), 50u);
  EXPECT_EQ(streak.stats.ends.at(EndReason::vertices), 1u);
}

/// Seven of eight lines end at once, where the field does: the eighth has what they leave over.
TEST(UnitLineBudget, IsSharedByThoseThatNeedIt) {
  const std::string field = "u=sqrt(0.5-y)+1,v=0,w=0";  // no number beyond y = 0.5
  std::vector<Vec3> seeds(8, Vec3(0, 1, 0));
  seeds[3] = Vec3(0);
  const auto lines = [&] {
    return lines_in(field, "stream-lines:step=1e-4,max-vertices=800", seeds, 2);
  };
  const IntegratedLines parallel = lines();
  EXPECT_EQ(parallel.lines.positions.size(), 800u);
  EXPECT_EQ(parallel.stats.ends, (EndCounts{{EndReason::not_finite, 7}, {EndReason::vertices, 1}}));
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(lines().lines.positions, parallel.lines.positions);
}

TEST(UnitLineBudget, ThatGivesALineLessThanTwoIsRefused) {
  const std::vector<Vec3> seeds(6, Vec3(0));
  EXPECT_THROW(lines_in("u=1,v=0,w=0", "stream-lines:max-vertices=11", seeds, 2), InputError);
  EXPECT_EQ(
      lines_in("u=1,v=0,w=0", "stream-lines:max-vertices=12", seeds, 2).lines.positions.size(),
      12u);
}

/// e^709 is below the largest double, e^710 above: x there, not its square, is what ends.
TEST(UnitLineBudget, WhatOverflowsIsNotFiniteSoon) {
  const auto grown = lines_in("u=x,v=0,w=0", "stream-lines", {Vec3(1, 0, 0)}, 800);
  EXPECT_EQ(grown.stats.ends, (EndCounts{{EndReason::not_finite, 1}}));
  EXPECT_GT(grown.lines.positions.back().x, 1e307);
  EXPECT_LT(grown.stats.evaluations, 1'500'000u);
  const auto gone = lines_in("u=1e300,v=0,w=0", "stream-lines", {Vec3(0)}, 1e10);
  EXPECT_EQ(gone.stats.ends, (EndCounts{{EndReason::not_finite, 1}}));
  for (const Vec3& x : gone.lines.positions) EXPECT_TRUE(std::isfinite(x.x));
}

/// Squares of the speed are 0 in a double.
TEST(UnitLineBudget, SlowFlowsMoveInLongTimes) {
  const auto straight = lines_in("u=1e-200,v=0,w=0", "stream-lines", {Vec3(0)}, 1e200);
  EXPECT_EQ(straight.stats.ends, (EndCounts{{EndReason::duration, 1}}));
  EXPECT_NEAR(straight.lines.positions.back().x, 1, 1e-8);
  const auto length = lines_in("u=1e-200,v=0,w=0", "stream-lines:length=0.3", {Vec3(0)}, 1e200);
  EXPECT_NEAR(length.lines.positions.back().x, 0.3, 1e-8);
  const auto round = lines_in("u=-1e-200*y,v=1e-200*x,w=0", "stream-lines", {Vec3(1, 0, 0)}, 1e200);
  EXPECT_NEAR(round.lines.positions.back().y, std::sin(1.), 1e-8);
  const auto field = fields::make_field("formula:u=-1e-200*y,v=1e-200*x,w=0");
  const SurfaceRequest request{field.get(), segment_seed({0, 0, 0}, {2, 0, 0}), 2e200, 0, false,
                               {}};
  const auto surface = integrate_surface("hultquist:threshold=0.2", request);
  EXPECT_LE(measure_error(surface.mesh, request, 300).max, 1e-8);
}

TEST(UnitLineBudget, RestEverywhereMakesNoLine) {
  for (const char* integrator : {"stream-lines", "streak-lines"}) {
    try {
      lines_in("u=0,v=0,w=0", integrator, {Vec3(0), Vec3(1)}, 2);
      ADD_FAILURE() << integrator;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("they ended: 2 stagnated, in formula"));
    }
  }
}

}  // namespace
}  // namespace pellucid::integrators
