// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/level.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "fields/finite.h"

namespace pellucid::fields {
namespace {

bool finite_sample(double sample) { return std::isfinite(sample); }
template <class T>
bool finite_sample(const glm::vec<3, T>& sample) {
  return is_finite(Vec3(sample));
}

template <class T>
void check(const std::string& name, const Level<T>& level) {
  const auto fail = [&](const std::string& why) {
    throw InputError(fmt::format("{}: {}", name, why));
  };
  if (!(level.width > 0) || !std::isfinite(level.width) || !is_finite(level.origin))
    fail(fmt::format("cells of width {}; accepted: a positive width and a finite origin",
                     level.width));
  std::size_t count = 1;
  for (const int n : level.size) {
    if (n < fewest_samples)
      fail(fmt::format("{} × {} × {} samples; accepted: at least {} along each axis", level.size[0],
                       level.size[1], level.size[2], fewest_samples));
    count *= std::size_t(n);
  }
  if (level.samples.size() != count)
    fail(fmt::format("{} samples; its size needs {}", level.samples.size(), count));
  for (std::size_t i = 0; i < count; ++i)
    if (!finite_sample(level.samples[i]))
      fail(fmt::format("sample {} is not finite; accepted: finite numbers", i));
}

}  // namespace

void check_level(const std::string& name, const ScalarLevel& level) { check(name, level); }
void check_level(const std::string& name, const VectorLevel& level) { check(name, level); }
void check_level(const std::string& name, const DoubleLevel& level) { check(name, level); }
void check_level(const std::string& name, const DoubleVectorLevel& level) { check(name, level); }

}  // namespace pellucid::fields
