// SPDX-License-Identifier: GPL-3.0-or-later
// Why particles end, and that those which have not come to an end go on: against closed forms, for
// every stepper, line and surface integrator.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/files/output_file.h"
#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "integrators/lines/integrate_lines.h"
#include "integrators/paths/butcher_tableau.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/integrators/lines/traced.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/mesh_area.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::integrators {
namespace {

using testing::boxed;
using testing::end_of;
using testing::everywhere;
using testing::FunctionField;
using testing::TemporaryFolder;
using testing::trace;

/// Velocity (speed(t), 0, 0) everywhere.
FunctionField wind(std::function<double(double t)> speed) {
  return FunctionField(
      [=](const Vec3&, double t, Vec3& v) {
        v = Vec3(speed(t), 0, 0);
        return fields::SampleStatus::ok;
      },
      false);
}

TEST(PropertyEnds, WhoRestsIsMovedWhenTheFlowSetsIn) {
  const FunctionField grows = wind([](double t) { return t; });
  const FunctionField sets_in = wind([](double t) { return std::max(0., t - 1); });
  for (const ButcherTableau& row : steppers()) {
    // Euler's steps of T / 500 miss half of their last one's speed; the others err by 1e-9 a step.
    const double error = row.order == 1 ? 4. / 500 : 1e-6;
    for (const Vec3& seed : {Vec3(0), Vec3(3, -2, 1)})
      for (const double T : {1.5, 2., 4.}) {
        const std::string integrator = fmt::format("path-lines:stepper={}", row.name);
        const double scale = T * T;
        EXPECT_NEAR(end_of(grows, integrator, seed, T).x - seed.x, T * T / 2, error * scale);
        EXPECT_NEAR(end_of(sets_in, integrator, seed, T).x - seed.x, (T - 1) * (T - 1) / 2,
                    error * scale)
            << row.name << " " << T;
      }
  }
}

TEST(PropertyEnds, VerticesKeepTheirDistanceFromRestToo) {
  const FunctionField grows = wind([](double t) { return t; });
  const auto lines = trace(grows, "path-lines:step=0.05", {Vec3(0)}, 2).lines;
  // The first vertex after rest, where speed tells nothing.
  ASSERT_GT(lines.positions.size(), 2u);
  EXPECT_LE(lines.positions[1].x, 0.05 + 1e-9);
  EXPECT_GT(lines.positions[1].x, 1e-3);
}

TEST(UnitEnds, AStreakLineReachesBackToRest) {
  const FunctionField grows = wind([](double t) { return t; });
  const auto lines = trace(grows, "streak-lines:releases=20", {Vec3(0)}, 2).lines;
  ASSERT_EQ(lines.positions.size(), 21u);
  for (std::size_t i = 0; i <= 20; ++i) {
    const double released = 2 - 0.1 * double(i);
    EXPECT_NEAR(lines.positions[i].x, (4 - released * released) / 2, 1e-6) << i;
  }
}

TEST(PropertyEnds, PathSurfacesFromRestHaveTheirArea) {
  const FunctionField grows = wind([](double t) { return t; });
  for (const IntegratorRow& row : integrators())
    for (const double T : {1., 2.}) {
      const SurfaceRequest request{&grows, segment_seed({0, 0, 0}, {0, 1, 0}), T, 0, true, {}};
      // A rectangle, flat: every vertex is off by 1e-9 a step.
      EXPECT_NEAR(testing::area_of(integrate_surface(row.name, request).mesh), T * T / 2, 1e-6)
          << row.name;
    }
}

TEST(PropertyEnds, TheLengthIsTheLengthHoweverLongTheSteps) {
  const auto uniform = everywhere([](const Vec3&) { return Vec3(0, 3, 4); });
  const auto circle = everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0); });
  const FunctionField grows = wind([](double t) { return t; });
  for (const ButcherTableau& row : steppers())
    for (const double length : {1e-3, 2., 5.}) {
      const std::string options = fmt::format(":stepper={},length={}", row.name, length);
      const auto straight = trace(uniform, "stream-lines" + options, {Vec3(0)}, 100);
      EXPECT_NEAR(glm::length(straight.lines.positions.back()), length, 1e-9) << options;
      EXPECT_EQ(straight.stats.ends, (EndCounts{{EndReason::length, 1}})) << options;
      if (row.order == 1) continue;  // its circle is another one
      const Vec3 end = end_of(circle, "stream-lines" + options, {1, 0, 0}, 20);
      // RK4 with steps of 0.04, 0.04⁴ / 120 for each unit of length; DOPRI5's dense output is of
      // fourth order at 1e-9 a step.
      EXPECT_LE(glm::distance(end, Vec3(std::cos(length), std::sin(length), 0)), 1e-6) << options;
      EXPECT_NEAR(end_of(grows, "path-lines" + options, Vec3(0), 10).x, length, 1e-6) << options;
    }
}

TEST(PropertyEnds, SurfacesOfALengthHaveItsArea) {
  const auto uniform = everywhere([](const Vec3&) { return Vec3(1, 0, 0); });
  const SurfaceRequest request{&uniform, segment_seed({0, 0, 0}, {0, 1, 0}), 100, 0, false, {}};
  for (const IntegratorRow& row : integrators()) {
    const auto surface = integrate_surface(fmt::format("{}:length=2", row.name), request);
    EXPECT_NEAR(testing::area_of(surface.mesh), 2, 1e-9) << row.name;
  }
}

TEST(PropertyEnds, ASingleSeedStaysOnItsCircleHoweverLong) {
  const auto circle = everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0); });
  const auto in_box = boxed([](const Vec3& x) { return Vec3(-x.y, x.x, 0); }, 2);
  for (const fields::VectorField* field :
       {(const fields::VectorField*)&circle, (const fields::VectorField*)&in_box})
    for (const double T : {10., 1e3, 1e4}) {
      const Vec3 end = end_of(*field, "stream-lines:step=1", {1, 0, 0}, T);
      // Steps of some 0.1, each off by less than 1e-9 of the radius, all the same way.
      EXPECT_LE(glm::distance(end, Vec3(std::cos(T), std::sin(T), 0)), 1e-8 * std::max(T, 10.));
    }
}

TEST(UnitEnds, ASinkIsAnEndAndAClosedOrbitIsNot) {
  struct Case {
    std::function<Vec3(const Vec3&)> velocity;
    EndReason end;
  };
  const Case cases[] = {
      {[](const Vec3& x) { return -x; }, EndReason::stagnated},
      {[](const Vec3& x) { return Vec3(-x.x, -10 * x.y, 0); }, EndReason::stagnated},
      {[](const Vec3& x) { return Vec3(-x.x + x.y, -x.x - x.y, 0); }, EndReason::stagnated},
      {[](const Vec3& x) { return Vec3(-0.1 * x.x + x.y, -x.x - 0.1 * x.y, 0); },
       EndReason::stagnated},
      {[](const Vec3& x) { return Vec3(-x.y, x.x, 0); }, EndReason::duration},
      {[](const Vec3& x) { return Vec3(-x.x, -1e-3 * x.y, 1e-6); }, EndReason::duration}};
  for (const Case& sample : cases)
    for (const double T : {1e3, 1e5}) {
      if (sample.end == EndReason::duration && T > 1e3) continue;  // more steps than are allowed
      const auto field = everywhere(sample.velocity);
      const auto traced = trace(field, "stream-lines:step=1e9", {{1, 0.5, 0}}, T);
      EXPECT_EQ(traced.stats.ends, (EndCounts{{sample.end, 1}})) << &sample - cases << " " << T;
      if (sample.end != EndReason::stagnated) continue;
      EXPECT_LE(glm::length(traced.lines.positions.back()), 1e-7) << &sample - cases;
      EXPECT_LE(traced.stats.evaluations, 50000u) << &sample - cases;
    }
}

TEST(UnitEnds, SeedsOutsideAreCountedOrRefusedWithTheBounds) {
  const auto in_box = boxed([](const Vec3&) { return Vec3(1, 0, 0); }, 1);
  const auto some = trace(in_box, "stream-lines", {{0, 0, 0}, {5, 0, 0}, {-0.5, 0, 0}}, 0.5);
  EXPECT_EQ(some.stats.ends.at(EndReason::outside), 1u);
  EXPECT_EQ(some.stats.ends.at(EndReason::duration), 2u);
  for (const LineIntegratorRow& row : line_integrators())
    EXPECT_THROW(trace(in_box, row.name, {{5, 0, 0}, {6, 0, 0}}, 1), InputError) << row.name;
  // On the edge that it flows out of, there is a vertex and no line.
  EXPECT_THROW(trace(in_box, "stream-lines", {{1, 0, 0}}, 1), InputError);
}

std::string write_box(const TemporaryFolder& folder, float low, float spacing) {
  std::string raw;
  for (int i = 0; i < 27; ++i) {
    const Vec3 v(0, 1, 0);
    raw.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  write_text(folder / "box.raw", raw);
  write_text(folder / "box.mhd",
             fmt::format("ObjectType = Image\nNDims = 3\nDimSize = 3 3 3\n"
                         "ElementSpacing = {0:.17g} {0:.17g} {0:.17g}\n"
                         "Offset = {1:.17g} {1:.17g} {1:.17g}\nElementType = MET_DOUBLE\n"
                         "ElementNumberOfChannels = 3\nBinaryDataByteOrderMSB = False\n"
                         "ElementDataFile = box.raw\n",
                         double(spacing), double(low)));
  return (folder / "box.mhd").string();
}

TEST(UnitEnds, TheMessageNamesTheBounds) {
  const TemporaryFolder folder;
  const auto field = fields::make_field(write_box(folder, -1, 1));
  try {
    trace(*field, "stream-lines", {{5, 0, 0}}, 1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("from (-1, -1, -1) to (1, 1, 1)"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("box.mhd"));
  }
}

TEST(UnitEnds, ASeedOnAnEdgeThatFloatsRoundIsInside) {
  const TemporaryFolder folder;
  for (const auto& [low, spacing] : {std::pair(0.1f, 0.1f), {0.3f, 0.7f}, {-7.3f, 0.1f}}) {
    const auto field = fields::make_field(write_box(folder, low, spacing));
    // What who reads the bounds as decimals types: both edges, of which one lies outside.
    for (int corner = 0; corner < 2; ++corner) {
      const double exact = std::round(1e3 * (double(low) + 2 * corner * double(spacing))) / 1e3;
      const Vec3 seed(exact, low + 0.5 * spacing, low + spacing);
      const auto traced = trace(*field, "stream-lines", {seed}, 0.5 * spacing);
      EXPECT_EQ(traced.stats.ends, (EndCounts{{EndReason::duration, 1}})) << low << " " << corner;
    }
    // A millionth of the bounds is no rounding.
    EXPECT_THROW(trace(*field, "stream-lines", {{low - 1e-5, low + 0.1 * spacing, low}}, 1e-3),
                 InputError);
  }
}

}  // namespace
}  // namespace pellucid::integrators
