// SPDX-License-Identifier: GPL-3.0-or-later

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "core/files/output_file.h"
#include "fields/make_field.h"
#include "tests/fields/probe.h"
#include "tests/fields/readers/grid_files.h"

namespace pellucid::fields {
namespace {

using ::testing::HasSubstr;

class UnitSeries : public ::testing::Test {
 protected:
  UnitSeries() {
    for (int k = 0; k < 3; ++k)
      write_cube(folder_ / fmt::format("{}.vti", k), 3, [k](const Vec3& x) {
        return Vec3(k * k, x.x * k, 1);  // v_x = t² at t = 0, 1, 3 would be 0, 1, 9
      });
    write_bytes(folder_ / "flow.vti.series",
                R"({"file-series-version": "1.0", "files": [{"name": "0.vti", "time": 0},
                    {"name": "1.vti", "time": 1}, {"name": "2.vti", "time": 3}]})");
  }

  std::string complaint(std::string_view text) {
    write_bytes(folder_ / "bad.series", text);
    try {
      make_field((folder_ / "bad.series").string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }

  std::string path() const { return (folder_ / "flow.vti.series").string(); }
  TemporaryFolder folder_;
};

TEST_F(UnitSeries, IsLinearBetweenItsFiles) {
  const auto field = make_field(path());
  const Vec3 x(0.25, 0.5, 0.75);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 0), Vec3(0, 0, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 0.5), Vec3(0.5, 0.125, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 1), Vec3(1, 0.25, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 2.5), Vec3(1 + 0.75 * 3, 0.25 * 1.75, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 3), Vec3(4, 0.5, 1), 1e-15);
}

TEST_F(UnitSeries, EndsWithItsTimes) {
  const auto field = make_field(path());
  EXPECT_EQ(status_at(*field, Vec3(0.5), -0.001), SampleStatus::outside);
  EXPECT_EQ(status_at(*field, Vec3(0.5), 3.001), SampleStatus::outside);
  EXPECT_EQ(status_at(*field, Vec3(0.5), std::nan("")), SampleStatus::outside);
  EXPECT_EQ(status_at(*field, Vec3(1.5), 1), SampleStatus::outside);
}

/// 0.1 + 0.2 is 0.30000000000000004, and 0.3 - 0.2 is less than 0.1; a float's 0.1 is more.
TEST_F(UnitSeries, ForgivesARoundingOfItsTimes) {
  write_bytes(folder_ / "tenths.series",
              R"({"files": [{"name": "0.vti", "time": 0.1}, {"name": "1.vti", "time": 0.3}]})");
  const auto field = make_field((folder_ / "tenths.series").string());
  const Vec3 x(0.5);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 0.1 + 0.2), Vec3(1, 0.5, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*field, x, 0.3 - 0.2), Vec3(0, 0, 1), 1e-15);
  EXPECT_EQ(status_at(*field, x, 0.1 - 1e-6), SampleStatus::outside);
  EXPECT_EQ(status_at(*field, x, 0.3 + 1e-6), SampleStatus::outside);
  write_bytes(
      folder_ / "late.series",
      R"({"files": [{"name": "0.vti", "time": 1e9}, {"name": "1.vti", "time": 1000000001}]})");
  const auto late = make_field((folder_ / "late.series").string());
  EXPECT_EQ(status_at(*late, x, std::nextafter(1e9, 0)), SampleStatus::ok);
}

/// Two frames at nearly one time are no reason for short steps between the others.
TEST_F(UnitSeries, ItsSpacingIsThatOfAllButAFiftiethOfItsTime) {
  const auto spacing = [&](std::string_view times) {
    write_bytes(folder_ / "near.series", times);
    return *make_field((folder_ / "near.series").string())->time_spacing();
  };
  EXPECT_DOUBLE_EQ(spacing(R"({"files": [{"name": "0.vti", "time": 0}, {"name": "1.vti", "time":
                           1e-6}, {"name": "2.vti", "time": 0.5}, {"name": "0.vti", "time": 1}]})"),
                   0.499999);
  EXPECT_DOUBLE_EQ(spacing(R"({"files": [{"name": "0.vti", "time": 0}, {"name": "1.vti", "time":
                           0.0625}, {"name": "2.vti", "time": 1}]})"),
                   0.0625);
  EXPECT_DOUBLE_EQ(*make_field(path())->time_spacing(), 1);
}

TEST_F(UnitSeries, OfOneFileIsThatFile) {
  write_bytes(folder_ / "one.series", R"({"files": [{"name": "1.vti", "time": 5}]})");
  const auto field = make_field((folder_ / "one.series").string());
  EXPECT_TRUE(field->steady());
  EXPECT_NEAR_VEC(velocity_of(*field, Vec3(0.5)), Vec3(1, 0.5, 1), 1e-15);
}

TEST_F(UnitSeries, HasTheJacobianOfItsVelocity) {
  const auto field = make_field(path());
  expect_consistent_jacobian(*field, {0.3, 0.6, 0.2}, 2.2, 1e-6, 1e-9);
  EXPECT_FALSE(field->steady());
  EXPECT_DOUBLE_EQ(*field->cell_size(), 0.5);
}

// v_x goes 0, 1, 4 at 0, 1, 3: ∂²v_x/∂t² = 2 (3/2 - 1)/3 = 1/3, over gaps of 2 at most; v_y, which
// has x t there, has 2 (1/2 - 1) x/3. In space every file is linear.
TEST_F(UnitSeries, ReportsItsErrorInTime) {
  const double at_x_1 = std::hypot(1.0 / 3, 1.0 / 3) * 4 / 8;
  EXPECT_NEAR(*make_field(path())->sampling_error(), at_x_1, 0.01);
}

TEST_F(UnitSeries, HandsOptionsToItsFiles) {
  EXPECT_THAT([&] { make_field(path() + ":array=wind"); },
              ::testing::ThrowsMessage<InputError>(HasSubstr("array=wind: no such vectors")));
}

TEST_F(UnitSeries, FilesMayHaveAnyOrder) {
  write_bytes(folder_ / "unsorted.series",
              R"({"files": [{"name": "2.vti", "time": 3}, {"name": "0.vti", "time": 0},
                            {"name": "1.vti", "time": 1}]})");
  const std::string unsorted = (folder_ / "unsorted.series").string();
  const Vec3 x(0.25, 0.5, 0.75);
  EXPECT_NEAR_VEC(velocity_of(*make_field(unsorted), x, 2.5), Vec3(1 + 0.75 * 3, 0.25 * 1.75, 1),
                  1e-15);
  EXPECT_NEAR_VEC(velocity_of(*make_field(unsorted + ":time=last"), x), Vec3(4, 0.5, 1), 1e-15);
  EXPECT_NEAR_VEC(velocity_of(*make_field(unsorted + ":time=first"), x), Vec3(0, 0, 1), 1e-15);
}

/// Only one in each: nobody asked for those of another name.
TEST_F(UnitSeries, FilesHaveTheVectorsOfTheFirst) {
  std::string other = read_text(folder_ / "1.vti");
  for (std::size_t at = other.find("velocity"); at != std::string::npos;
       at = other.find("velocity", at))
    other.replace(at, 8, "vorticity");
  write_bytes(folder_ / "other.vti", other);
  constexpr std::string_view text =
      R"({"files": [{"name": "0.vti", "time": 0}, {"name": "other.vti", "time": 1}]})";
  EXPECT_THAT(complaint(text), HasSubstr("array=velocity: no such vectors"));
}

TEST_F(UnitSeries, RefusesWhatItCannotRead) {
  EXPECT_THAT(complaint("{"), HasSubstr("bad.series: parse error"));
  EXPECT_THAT(complaint("[]"), HasSubstr("one or more"));
  EXPECT_THAT(complaint(R"({"files": []})"), HasSubstr("one or more"));
  EXPECT_THAT(
      complaint(R"({"files": [{"name": "0.vti", "time": 1}, {"name": "1.vti", "time": 1}]})"),
      HasSubstr("its time number 1 is 1, after 1; times have to ascend"));
  EXPECT_THAT(
      complaint(R"({"files": [{"name": "0.vti", "time": 0}, {"name": "9.vti", "time": 1}]})"),
      ::testing::ContainsRegex("bad.series: files\\[1\\]: .*9.vti: cannot read"));
  EXPECT_THAT(complaint(R"({"files": [{"name": "0.vti"}, {"name": "1.vti", "time": 1}]})"),
              HasSubstr("files[0]: expected"));
  EXPECT_THAT(
      complaint(R"({"files": [{"name": "bad.series", "time": 0}, {"name": "1.vti", "time": 1}]})"),
      HasSubstr("no series in a series"));
  write_bytes(folder_ / "two.pvd",
              R"(<VTKFile type="Collection"><Collection><DataSet timestep="0" file="0.vti"/>
                 <DataSet timestep="1" file="1.vti"/></Collection></VTKFile>)");
  EXPECT_THAT(
      complaint(R"({"files": [{"name": "two.pvd", "time": 0}, {"name": "1.vti", "time": 1}]})"),
      HasSubstr("files[0]: 'two.pvd' has several times of its own"));
}

}  // namespace
}  // namespace pellucid::fields
