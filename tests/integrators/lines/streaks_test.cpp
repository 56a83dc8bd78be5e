// SPDX-License-Identifier: GPL-3.0-or-later
// Streak lines some of whose particles are gone.
#include <gmock/gmock.h>

#include <cmath>

#include "fields/make_field.h"
#include "integrators/lines/integrate_lines.h"
#include "tests/integrators/lines/trajectory_error.h"

namespace pellucid::integrators {
namespace {

using ::testing::ElementsAre;

/// Particles let go from t = -2 to 4, every 0.1.
LineRequest smoke(const fields::VectorField& field, std::vector<Vec3> seeds) {
  LineRequest request;
  request.field = &field;
  request.seeds = std::move(seeds);
  request.duration = 6;
  request.start_time = -2;
  return request;
}

constexpr double apart = 0.1;
const std::string integrator = "streak-lines:releases=60";

/// At 1 along x; between t = 2 and 2.5 the fluid is gone where 1 < x < 2. There are, at t, those
/// let go from t - 2 to t - 1: of all at t = 4, those that have come to x = 2.5 to 4.
const char* const hole = "formula:u=((t>2)&&(t<2.5)&&(x>1)&&(x<2))?sqrt(-1):1,v=0,w=0";

/// A particle stands for the stretch to the next one.
void expect_line(const geometry::LineSet& lines, std::size_t k, double from, double to) {
  const std::size_t begin = lines.offsets[k], end = lines.offsets[k + 1];
  EXPECT_NEAR(lines.positions[begin].x, from, apart + trajectory_error);
  EXPECT_NEAR(lines.positions[end - 1].x, to, apart + trajectory_error);
  EXPECT_NEAR(double(end - begin), std::abs(to - from) / apart, 1.001);
  for (std::size_t i = begin; i < end; ++i)
    EXPECT_NEAR(lines.positions[i].x, lines.scalars.at("t")[i], trajectory_error);
}

TEST(UnitStreaks, AGapPartsALine) {
  const auto field = fields::make_field(hole);
  const IntegratedLines result = integrate_lines(integrator, smoke(*field, {{0, 0, 0}, {3, 0, 0}}));
  EXPECT_THAT(result.seeds, ElementsAre(0u, 0u, 1u));
  ASSERT_EQ(result.lines.line_count(), 3u);
  expect_line(result.lines, 0, 0, 2.5);
  expect_line(result.lines, 1, 4, 6);
  EXPECT_EQ(result.lines.offsets[3] - result.lines.offsets[2], 61u);
  // The seed itself is where the line begins, and no particle.
  const EndCounts& ends = result.stats.ends;
  EXPECT_EQ(ends.at(EndReason::duration), result.lines.positions.size() - 2);
  EXPECT_EQ(ends.at(EndReason::duration) + ends.at(EndReason::not_finite), 120u);
  EXPECT_EQ(result.stats.particles, 120u);
}

/// Against time there is no hole: particles let go until t = -8 are at x = -6 to 0 then.
TEST(UnitStreaks, BothWaysMeetAtTheSeedAlone) {
  const auto field = fields::make_field(hole);
  LineRequest request = smoke(*field, {{0, 0, 0}});
  request.both = true;
  const IntegratedLines result = integrate_lines(integrator, request);
  EXPECT_THAT(result.seeds, ElementsAre(0u, 0u));
  expect_line(result.lines, 0, -6, 2.5);
  expect_line(result.lines, 1, 4, 6);
  EXPECT_NEAR(result.lines.positions[0].x, -6, trajectory_error);
}

/// Those let go last are gone, and the seed has no velocity at the end: so are all that come to
/// less than 0.55 + 0.1 at t = 4.
TEST(UnitStreaks, ACoveredSeedHidesNoOlderParticle) {
  const auto field = fields::make_field("formula:u=((t>3.9)&&(x<0.55))?sqrt(-1):1,v=0,w=0");
  LineRequest request = smoke(*field, {{0, 0, 0}});
  const IntegratedLines result = integrate_lines(integrator, request);
  ASSERT_EQ(result.lines.line_count(), 1u);
  expect_line(result.lines, 0, 0.65, 6);
  request.both = true;  // what lies before the seed does not reach it
  const IntegratedLines both = integrate_lines(integrator, request);
  ASSERT_EQ(both.lines.line_count(), 2u);
  expect_line(both.lines, 0, -6, 0);
  expect_line(both.lines, 1, 0.65, 6);
}

/// Where the field does not change, who is let go before has left before.
TEST(UnitStreaks, NobodyIsSentInVainInASteadyField) {
  const auto field = fields::make_field("formula:u=x>2?sqrt(-1):1,v=0,w=0");
  const IntegratedLines result = integrate_lines(integrator, smoke(*field, {{0, 0, 0}}));
  ASSERT_EQ(result.lines.line_count(), 1u);
  expect_line(result.lines, 0, 0, 2);
  EXPECT_EQ(result.stats.ends.at(EndReason::not_finite), 1u);
}

}  // namespace
}  // namespace pellucid::integrators
