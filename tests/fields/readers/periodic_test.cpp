// SPDX-License-Identifier: GPL-3.0-or-later
// Grids that repeat themselves.

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"
#include "tests/fields/readers/xml_grids.h"

namespace pellucid::fields {
namespace {

using namespace xml_grids;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr double period_x = 4, period_y = 1.5;

Vec3 wave(const Vec3& x) {
  const double a = 2 * M_PI * x.x / period_x, b = 2 * M_PI * x.y / period_y;
  return {std::sin(a) + std::cos(b), std::cos(a) * std::sin(b), x.z + std::cos(a)};
}

class UnitPeriodic : public ::testing::Test {
 protected:
  std::unique_ptr<VectorField> read(const Axes& axes, std::string_view options,
                                    const VectorAt& velocity = wave) {
    return read_text(rectilinear(axes, vectors("U", crossings(axes), velocity)), options);
  }
  std::unique_ptr<VectorField> read_text(const std::string& text, std::string_view options) {
    write_bytes(folder_ / "p.vtr", text);
    return make_field((folder_ / "p.vtr").string() + std::string(options));
  }
  std::string complaint(const Axes& axes, std::string_view options,
                        const VectorAt& velocity = wave) {
    try {
      read(axes, options, velocity);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  TemporaryFolder folder_;
};

// One period without its last layer, which is the first again, and three periods with all.
const Axes once{evenly(1, 0.25, 16), evenly(0, 0.125, 12), evenly(0, 1, 5)};
const Axes three_times{evenly(-3, 0.25, 49), evenly(-1.5, 0.125, 37), evenly(0, 1, 5)};

TEST_F(UnitPeriodic, OnePeriodIsAsGoodAsThree) {
  for (const std::string sampler : {"linear", "c1"}) {
    const auto periodic = read(once, ":periodic=x,y,sampler=" + sampler);
    const auto whole = read(three_times, ":sampler=" + sampler);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> along_x(1, 5), along_y(0, 1.5), along_z(0, 4);
    for (int i = 0; i < 500; ++i) {
      const Vec3 x(along_x(random), along_y(random), along_z(random));
      const Vec3 turns(period_x * (i % 7 - 3), period_y * (i % 5 - 2), 0);
      Vec3 v, w;
      Mat3 slope_v, slope_w;
      ASSERT_EQ(periodic->sampler()->velocity_and_jacobian(x + turns, 0, v, slope_v),
                SampleStatus::ok);
      ASSERT_EQ(whole->sampler()->velocity_and_jacobian(x, 0, w, slope_w), SampleStatus::ok);
      EXPECT_NEAR_VEC(v, w, 1e-12) << sampler;
      EXPECT_LE(norm(slope_v - slope_w), 1e-10);  // a rounded place times the second derivative
    }
    EXPECT_THAT(periodic->description(),
                HasSubstr("periodic along x over 4, periodic along y over 1.5"));
    EXPECT_EQ(periodic->domain().max.x, std::numeric_limits<double>::infinity());
    EXPECT_EQ(periodic->domain().max.z, 4);
  }
}

TEST_F(UnitPeriodic, ALastLayerThatIsTheFirstAgainEndsThePeriod) {
  const Axes closed{evenly(1, 0.25, 17), evenly(0, 0.125, 13), evenly(0, 1, 5)};
  for (const char* options : {":periodic=x,y", ":periodic=x:4,y:1.5"}) {
    const auto field = read(closed, options);
    const auto open = read(once, ":periodic=x,y");
    for (const double x : {1.0, 4.9, 5.0, 5.1, 21.3})
      EXPECT_NEAR_VEC(velocity_of(*field, {x, 1.45, 2.5}), velocity_of(*open, {x, 1.45, 2.5}),
                      1e-12);
    EXPECT_THAT(field->description(), HasSubstr("x over 4, periodic along y over 1.5"));
  }
}

/// A pulse that has not reached the ends is alike there, whatever the period.
TEST_F(UnitPeriodic, TimesOfASeriesHaveOnePeriod) {
  const auto pulse = [](const Vec3& x) { return Vec3(x.x == 2 ? 1 : 0, 0, 0); };
  const auto series = [&](const VectorAt& first, const VectorAt& last) {
    write_bytes(folder_ / "a.vtr", rectilinear(once, vectors("U", crossings(once), first)));
    write_bytes(folder_ / "b.vtr", rectilinear(once, vectors("U", crossings(once), last)));
    write_bytes(folder_ / "p.series",
                R"({"files": [{"name": "a.vtr", "time": 0}, {"name": "b.vtr", "time": 1}]})");
    return make_field((folder_ / "p.series").string() + ":periodic=x");
  };
  // 6 is 2 once around, in a period of 4.
  EXPECT_NEAR_VEC(velocity_of(*series(wave, pulse), {6, 1, 1}, 1), Vec3(1, 0, 0), 1e-12);
  try {
    series(pulse, wave);
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("accepted: periodic=x:LENGTH"));
  }
}

TEST_F(UnitPeriodic, UnevenSpacingNeedsALength) {
  Axes uneven = once;
  uneven[0] = {0, 0.5, 1.5, 2, 3};
  EXPECT_THAT(complaint(uneven, ":periodic=x"), HasSubstr("accepted: periodic=x:LENGTH"));
  const auto field = read(uneven, ":periodic=x:4");
  const Vec3 at_last = wave({3, 0.125, 1}), at_first = wave({0, 0.125, 1});
  EXPECT_NEAR_VEC(velocity_of(*field, {3.5, 0.125, 1}), 0.5 * (at_last + at_first), 1e-12);
  EXPECT_NEAR_VEC(velocity_of(*field, {-4.5, 0.125, 1}), 0.5 * (at_last + at_first), 1e-12);
}

TEST_F(UnitPeriodic, WhatDoesNotTellItsPeriodIsRefused) {
  EXPECT_THAT(complaint(once, ":periodic=z", [](const Vec3& x) { return Vec3(x.x, 0, 0); }),
              HasSubstr("periodic=z: its samples do not change along z"));
  EXPECT_THAT(complaint(once, ":periodic=x:3"), HasSubstr("accepted: at least 3.75"));
  for (const char* wrong : {":periodic=w", ":periodic=x,x", ":periodic=x:", ":periodic=x:-1",
                            ":periodic=,", ":periodic=xy"})
    EXPECT_THAT(complaint(once, wrong), HasSubstr("accepted: none, or axes among x, y, z"))
        << wrong;
}

TEST_F(UnitPeriodic, CellsTakeTheWholePeriod) {
  const Axes closed{evenly(1, 0.25, 17), evenly(0, 0.125, 13), evenly(0, 1, 5)};
  const std::string text = rectilinear(closed, {}, vectors("U", crossings(middles(closed)), wave));
  const auto constant = read_text(text, ":cells=constant,periodic=x,y");
  EXPECT_NEAR_VEC(velocity_of(*constant, {1.1 + 3 * period_x, 1.49 - period_y, 2.5}),
                  wave({1.125, 1.4375, 2.5}), 1e-12);
  // At the seam the mean is that of the cells on both sides, as everywhere.
  const auto averaged = read_text(text, ":periodic=x,y");
  const Axes around{evenly(-3, 0.25, 49), evenly(-1.5, 0.125, 37), evenly(0, 1, 5)};
  const auto whole =
      read_text(rectilinear(around, {}, vectors("U", crossings(middles(around)), wave)), "");
  for (const Vec3& x : {Vec3(1, 0, 2), Vec3(4.9, 1.45, 2.3), Vec3(1.1, 0.7, 3.5)})
    EXPECT_NEAR_VEC(velocity_of(*averaged, x + Vec3(2 * period_x, -period_y, 0)),
                    velocity_of(*whole, x), 1e-12);
}

TEST_F(UnitPeriodic, ALongitudeGoesAround) {
  const auto east = [](const Vec3& x) { return Vec3(1, 0, 0) * (2 + std::sin(x.x * M_PI / 180)); };
  const Axes open{evenly(0, 2, 180), evenly(-10, 10, 3), evenly(0, 1, 2)};
  const Axes closed{evenly(-180, 2, 181), evenly(-90, 90, 3), evenly(0, 1, 2)};
  for (const Axes& axes : {open, closed}) {
    const auto field = read(axes, "", east);
    EXPECT_THAT(field->description(), HasSubstr("x taken as a longitude"));
    EXPECT_NEAR_VEC(velocity_of(*field, {719, 0, 0.5}), 0.5 * (east({358, 0, 0}) + east({0, 0, 0})),
                    1e-12);
  }
  EXPECT_EQ(status_at(*read(open, ":periodic=none", east), {359, 0, 0.5}), SampleStatus::outside);
  // A section along one latitude; at 0 it may be anything.
  const Axes section{evenly(0, 2, 180), {45}, evenly(0, 1, 2)};
  EXPECT_NEAR_VEC(velocity_of(*read(section, "", east), {719, 45, 0.5}),
                  0.5 * (east({358, 0, 0}) + east({0, 0, 0})), 1e-12);
  const Axes flat{evenly(0, 2, 180), {0}, evenly(0, 1, 2)};
  EXPECT_EQ(status_at(*read(flat, "", east), {359, 0, 0.5}), SampleStatus::outside);
  // Not a longitude: no whole turn, no latitude beside it, or ends that differ.
  const Axes short_of{evenly(0, 2, 179), evenly(-10, 10, 3), evenly(0, 1, 2)};
  const Axes beyond_the_pole{evenly(0, 2, 180), evenly(0, 50, 3), evenly(0, 1, 2)};
  EXPECT_THAT(read(short_of, "", east)->description(), Not(HasSubstr("longitude")));
  EXPECT_THAT(read(beyond_the_pole, "", east)->description(), Not(HasSubstr("longitude")));
  EXPECT_THAT(read(closed, "", [](const Vec3& x) { return x; })->description(),
              Not(HasSubstr("longitude")));
}

/// As ERA5-Land (0.1 degrees), CMEMS (1/12) and others write them: in floats, and in decimals.
TEST_F(UnitPeriodic, ALongitudeIsOneInFloatsAndInDecimals) {
  const auto east = [](const Vec3&) { return Vec3(1, 0, 0); };
  const auto goes_around = [&](double first, int count, const auto& kept) {
    std::vector<double> x;
    for (int i = 0; i < count; ++i) x.push_back(kept(first + 360.0 * i / count));
    return read({x, evenly(-10, 10, 3), evenly(0, 1, 2)}, "", east)
               ->description()
               .find("x taken as a longitude") != std::string::npos;
  };
  const auto in_float = [](double x) { return double(float(x)); };
  const auto in_hundredths = [](double x) { return std::round(100 * x) / 100; };
  for (const double first : {0.0, -180.0, 0.05})
    for (const int count : {3600, 4320, 1440, 7200, 128})
      EXPECT_TRUE(goes_around(first, count, in_float)) << first << " " << count;
  for (const int count : {4320, 1080, 3600})
    EXPECT_TRUE(goes_around(0, count, in_hundredths)) << count;
}

TEST_F(UnitPeriodic, OtherGridsRefuse) {
  write_bytes(folder_ / "p.vts", structured(once, vectors("U", crossings(once), wave)));
  EXPECT_THROW(make_field((folder_ / "p.vts").string() + ":periodic=x"), InputError);
  EXPECT_NO_THROW(make_field((folder_ / "p.vts").string() + ":periodic=none"));
}

}  // namespace
}  // namespace pellucid::fields
