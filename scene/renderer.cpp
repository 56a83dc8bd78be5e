// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/renderer.h"

namespace pellucid::scene {

namespace {

std::optional<double> sum(const std::optional<double>& a, const std::optional<double>& b) {
  return a || b ? std::optional(a.value_or(0) + b.value_or(0)) : std::nullopt;
}

}  // namespace

StepTime& StepTime::operator+=(const StepTime& other) {
  seconds += other.seconds;
  gl_seconds = sum(gl_seconds, other.gl_seconds);
  return *this;
}

std::optional<double> RenderStats::gl_seconds() const {
  std::optional<double> all;
  for (const StepTime& step : steps) all = sum(all, step.gl_seconds);
  return all;
}

double RenderStats::seconds() const {
  double sum = 0;
  for (const StepTime& step : steps) sum += step.seconds;
  return sum;
}

std::uint64_t RenderStats::total_bytes() const {
  std::uint64_t sum = 0;
  for (const NamedBytes& part : bytes) sum += part.bytes;
  return sum;
}

}  // namespace pellucid::scene
