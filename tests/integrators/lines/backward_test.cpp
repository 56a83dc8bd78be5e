// SPDX-License-Identifier: GPL-3.0-or-later
// Lines against time, and in both directions.

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"
#include "fields/make_field.h"
#include "fields/reversed_field.h"
#include "integrators/lines/integrate_lines.h"
#include "tests/integrators/lines/trajectory_error.h"

namespace pellucid::integrators {
namespace {

LineRequest request_of(const fields::VectorField& field, double duration, double start_time = 0) {
  LineRequest request;
  request.field = &field;
  request.seeds = {{0.5, 1, 0.1}, {1, 0.25, 0}};
  request.duration = duration;
  request.start_time = start_time;
  return request;
}

TEST(UnitBackward, StreamLinesOfTheSaddle) {
  const auto field = fields::make_field("saddle");
  const LineRequest request = request_of(*field, -2);
  const geometry::LineSet lines = integrate_lines("stream-lines", request).lines;
  ASSERT_EQ(lines.line_count(), 2u);
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = lines.offsets[k]; i < lines.offsets[k + 1]; ++i) {
      const double t = lines.scalars.at("t")[i];
      const Vec3& seed = request.seeds[k];
      EXPECT_LE(glm::distance(lines.positions[i],
                              Vec3(seed.x * std::exp(t), seed.y * std::exp(-t), seed.z)),
                trajectory_error);
      EXPECT_LE(t, 0);
    }
  EXPECT_EQ(lines.scalars.at("t")[lines.offsets[1] - 1], -2);
}

TEST(UnitBackward, PathLinesGoBackThroughTheFieldsTime) {
  // v = (cos t, sin t, 0): x(t) = x₀ + (sin t - sin t₀, cos t₀ - cos t, 0).
  const auto field = fields::make_field("drift");
  const double start = 0.7;
  const LineRequest request = request_of(*field, -3, start);
  const geometry::LineSet lines = integrate_lines("path-lines", request).lines;
  for (std::size_t i = 0; i < lines.offsets[1]; ++i) {
    const double time = lines.scalars.at("time")[i];
    EXPECT_NEAR(time, start + lines.scalars.at("t")[i], 1e-15);
    const Vec3 way(std::sin(time) - std::sin(start), std::cos(start) - std::cos(time), 0);
    EXPECT_LE(glm::distance(lines.positions[i], request.seeds[0] + way), trajectory_error);
  }
  EXPECT_NEAR(lines.scalars.at("time")[lines.offsets[1] - 1], -2.3, 1e-15);
}

TEST(UnitBackward, BothWaysAreOneLine) {
  const auto field = fields::make_field("saddle");
  LineRequest request = request_of(*field, 1.5);
  request.both = true;
  const IntegratedLines result = integrate_lines("stream-lines", request);
  const geometry::LineSet& lines = result.lines;
  ASSERT_EQ(lines.line_count(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& t = lines.scalars.at("t");
    const std::size_t begin = lines.offsets[k], end = lines.offsets[k + 1];
    EXPECT_EQ(t[begin], -1.5);
    EXPECT_EQ(t[end - 1], 1.5);
    for (std::size_t i = begin + 1; i < end; ++i) EXPECT_GT(t[i], t[i - 1]);  // the seed once
    for (std::size_t i = begin; i < end; ++i)
      EXPECT_NEAR(lines.positions[i].x * lines.positions[i].y,
                  request.seeds[k].x * request.seeds[k].y, trajectory_error);
  }
  EXPECT_EQ(result.stats.ends.at(EndReason::duration), 4u);
  EXPECT_EQ(result.stats.particles, 4u);
}

TEST(UnitBackward, OneWayMayBeMissing) {
  // Nothing comes to the fluid's edge from outside: back from there the line is its seed alone.
  const auto field = fields::make_field("formula:u=sqrt(x),v=0,w=0");  // no number where x < 0
  LineRequest request = request_of(*field, 1);
  request.seeds = {{-1, 0, 0}, {1, 0, 0}};
  request.both = true;
  const geometry::LineSet lines = integrate_lines("stream-lines", request).lines;
  EXPECT_EQ(lines.offsets[1], 0u);
  EXPECT_GT(lines.offsets[2], 2u);
}

TEST(UnitBackward, NoDurationIsRefused) {
  const auto field = fields::make_field("saddle");
  EXPECT_THROW(integrate_lines("stream-lines", request_of(*field, 0)), InputError);
}

TEST(UnitBackward, AReversedFieldIsTheFieldMirrored) {
  const std::shared_ptr<const fields::VectorField> field = fields::make_field("pulsing-saddle");
  const auto back = fields::reversed(field, 2);
  Vec3 v, w;
  Mat3 slope_v, slope_w;
  field->sampler()->velocity_and_jacobian({1, 2, 3}, 1.25, v, slope_v);
  back->sampler()->velocity_and_jacobian({1, 2, 3}, 2.75, w, slope_w);
  EXPECT_EQ(w, -v);
  for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(slope_w[axis], -slope_v[axis]);
}

}  // namespace
}  // namespace pellucid::integrators
