// SPDX-License-Identifier: GPL-3.0-or-later
// Particles in samples: at the ends of their times, between frames, and to the accuracy that is
// given.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "core/files/output_file.h"
#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "integrators/surfaces/integrate_surface.h"
#include "tests/integrators/lines/traced.h"
#include "tests/integrators/test_fields.h"
#include "tests/support/temporary_folder.h"

namespace pellucid::integrators {
namespace {

using testing::end_of;
using testing::everywhere;
using testing::FunctionField;
using testing::TemporaryFolder;
using testing::trace;

/// A series of frames (speed, 0, 0), a speed at each of the times.
class UnitSeriesEnds : public ::testing::Test {
 protected:
  std::shared_ptr<const fields::VectorField> series(const std::vector<double>& times,
                                                    const std::vector<double>& speeds) {
    std::string files;
    for (std::size_t k = 0; k < times.size(); ++k) {
      write_frame(speeds[k]);
      files +=
          fmt::format(R"({}{{"name": "{}.mhd", "time": {}}})", k ? ", " : "", speeds[k], times[k]);
    }
    write_text(folder_ / "pulse.series",
               fmt::format(R"({{"file-series-version": "1.0", "files": [{}]}})", files));
    return fields::make_field((folder_ / "pulse.series").string());
  }

 private:
  void write_frame(double speed) {
    std::string raw;
    for (int i = 0; i < 27; ++i) {
      const Vec3 v(speed, 0, 0);
      raw.append(reinterpret_cast<const char*>(&v), sizeof v);
    }
    write_text(folder_ / fmt::format("{}.raw", speed), raw);
    write_text(
        folder_ / fmt::format("{}.mhd", speed),
        fmt::format("ObjectType = Image\nNDims = 3\nDimSize = 3 3 3\nElementSpacing = 2 2 2\n"
                    "Offset = -2 -2 -2\nElementType = MET_DOUBLE\n"
                    "ElementNumberOfChannels = 3\nBinaryDataByteOrderMSB = False\n"
                    "ElementDataFile = {}.raw\n",
                    speed));
  }
  TemporaryFolder folder_;
};

/// 101 frames at rest but for one: a triangle in time of height 1 and base 2.
TEST_F(UnitSeriesEnds, OneFrameMovesWhoRests) {
  std::vector<double> times, speeds;
  for (int k = 0; k <= 100; ++k) times.push_back(k), speeds.push_back(k == 37 ? 1 : 0);
  EXPECT_NEAR(end_of(*series(times, speeds), "path-lines", Vec3(0), 100).x, 1, 1e-6);
}

/// A millionth between two frames of a whole of 1, which would be a million steps.
TEST_F(UnitSeriesEnds, TwoFramesAtNearlyOneTimeMakeNoShortSteps) {
  const auto field = series({0, 1e-6, 1}, {0, 0, 1});
  const auto lines = trace(*field, "path-lines", {Vec3(0)}, 1);
  EXPECT_NEAR(lines.lines.positions.back().x, 0.5, 1e-6);
  EXPECT_LE(lines.stats.evaluations, 5000u);
}

/// 0.1 + 0.2 is beyond 0.3, and 0.3 - 0.2 before 0.1.
TEST_F(UnitSeriesEnds, AWayToTheLastTimeIsWholeButForItsRounding) {
  const auto field = series({0.1, 0.3}, {1, 1});
  const auto backward = fields::reversed(field, 0.3);
  for (const auto& [way, start] : {std::pair(field, 0.1), {backward, 0.3}}) {
    const auto lines = integrate_lines("path-lines", {way.get(), {Vec3(0)}, 0.2, start, {}});
    EXPECT_EQ(lines.stats.ends, (EndCounts{{EndReason::duration, 1}})) << start;
    EXPECT_NEAR(std::abs(lines.lines.positions.back().x), 0.2, 1e-9);
  }
}

TEST_F(UnitSeriesEnds, AStartOutsideItsTimesIsRefusedByThem) {
  const auto field = series({0.1, 0.3}, {1, 1});
  for (const char* integrator : {"path-lines", "stream-lines", "streak-lines"}) {
    try {
      trace(*field, integrator, {Vec3(0)}, 0.2);
      ADD_FAILURE() << integrator;
    } catch (const InputError& error) {
      EXPECT_THAT(
          error.what(),
          ::testing::AllOf(::testing::HasSubstr("start-time: 0; accepted: one of the times"),
                           ::testing::HasSubstr("2 times from t = 0.1 to 0.3")));
    }
  }
}

/// A field of cells, which counts how often it is asked for its sampling error.
class CountingCells final : public fields::VectorField {
 public:
  std::unique_ptr<fields::FieldSampler> sampler() const override { return inner_.sampler(); }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override { return 0.5; }
  std::optional<double> sampling_error() const override { return ++asked, 1e-3; }
  std::string description() const override { return "cells"; }
  mutable int asked = 0;

 private:
  FunctionField inner_ = everywhere([](const Vec3& x) { return Vec3(-x.y, x.x, 0); });
};

TEST(UnitSampledEnds, TheSamplingErrorIsAskedForWhereItIsNeeded) {
  const auto asks = [](const auto& run) {
    const CountingCells field;
    run(field);
    return field.asked > 0;
  };
  const auto lines = [](std::string_view integrator) {
    return [=](const CountingCells& field) { trace(field, integrator, {Vec3(1, 0, 0)}, 1); };
  };
  const auto surface = [](std::string_view integrator) {
    return [=](const CountingCells& field) {
      integrate_surface(integrator,
                        {&field, segment_seed({1, 0, 0}, {2, 0, 0}), 0.5, 0, false, {}});
    };
  };
  EXPECT_TRUE(asks(lines("stream-lines")));
  EXPECT_FALSE(asks(lines("stream-lines:accuracy=1e-6")));
  EXPECT_FALSE(asks(lines("stream-lines:stepper=rk4")));
  // Of normals by the variational equation it bounds the error.
  EXPECT_TRUE(asks(surface("fixed-front:particles=3,rows=3,accuracy=1e-6")));
  EXPECT_FALSE(asks(surface("fixed-front:particles=3,rows=3,accuracy=1e-6,normals=none")));
}

TEST(AgreementSampledEnds, AnAccuracyThatIsGivenIsKept) {
  // Coarse samples of a swirl: their error is some percent, and says nothing of an accuracy.
  const TemporaryFolder folder;
  std::string raw;
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i) {
        const Vec3 x = 0.75 * Vec3(i, j, k),
                   v(std::sin(x.z) + std::cos(x.y), std::sin(x.x) + std::cos(x.z),
                     std::sin(x.y) + std::cos(x.x));
        raw.append(reinterpret_cast<const char*>(&v), sizeof v);
      }
  write_text(folder / "abc.raw", raw);
  write_text(folder / "abc.mhd",
             "ObjectType = Image\nNDims = 3\nDimSize = 9 9 9\nElementSpacing = 0.75 0.75 0.75\n"
             "ElementType = MET_DOUBLE\nElementNumberOfChannels = 3\n"
             "BinaryDataByteOrderMSB = False\nElementDataFile = abc.raw\n");
  const auto field = fields::make_field((folder / "abc.mhd").string());
  const auto end = [&](const char* accuracy) {
    return end_of(*field, fmt::format("stream-lines:accuracy={}", accuracy), {3, 3.1, 2.9}, 1);
  };
  // Ten to a hundred steps, stretched by the flow by e^√6 at most.
  EXPECT_LE(glm::distance(end("1e-9"), end("1e-12")), 1e-9 * 100 * 12);
  EXPECT_LE(glm::distance(end("1e-7"), end("1e-12")), 1e-7 * 100 * 12);
}

/// u = 1 and 2 in turn, in cells of width 1 that go on for ever, as of a file's that repeat
/// themselves.
class Stripes final : public fields::VectorField {
 public:
  std::unique_ptr<fields::FieldSampler> sampler() const override { return inner_.sampler(); }
  bool steady() const override { return true; }
  std::optional<double> cell_size() const override { return 1; }
  std::optional<double> sampling_error() const override { return 1; }
  std::string description() const override { return "stripes"; }

 private:
  FunctionField inner_ = everywhere(
      [](const Vec3& x) { return Vec3(1 + std::abs(std::remainder(std::floor(x.x), 2.)), 0, 0); });
};

TEST(UnitSampledEnds, CellsOfOneVelocityWithoutAnEndAreFollowedExactly) {
  // 1 in half a unit of time from 0.5, then 1.5 for each two cells.
  EXPECT_NEAR(end_of(Stripes(), "stream-lines", {0.5, 0.5, 0.5}, 0.5 + 10 * 1.5).x, 21, 1e-3);
}

TEST_F(UnitSeriesEnds, WhoStartsAtTheLastTimeIsToldOfTimes) {
  const auto field = series({0.1, 0.3}, {1, 1});
  try {
    integrate_lines("path-lines", {field.get(), {Vec3(0)}, 1, 0.3, {}});
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("between its times 0.1 and 0.3"));
  }
}

/// Particles are looked for at the end: beyond the series' times nobody is left, whatever the
/// place.
TEST_F(UnitSeriesEnds, StreaksAreToldThatTheyEndBeyondTheTimes) {
  const auto field = series({0.1, 0.3}, {1, 1});
  const auto refusal = [&](double duration, double start) -> std::string {
    try {
      integrate_lines("streak-lines", {field.get(), {Vec3(0)}, duration, start, {}});
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(refusal(1, 0.25),
              ::testing::StartsWith("duration: 1, which ends at the time 1.25 when particles are "
                                    "looked for; accepted: an end between the times 0.1 and 0.3"));
  EXPECT_THAT(refusal(-1, 0.25),
              ::testing::StartsWith("duration: -1, which ends at the time -0.75"));
  EXPECT_EQ(refusal(0.05, 0.25), "");
  EXPECT_EQ(refusal(-0.15, 0.25), "");
}

}  // namespace
}  // namespace pellucid::integrators
