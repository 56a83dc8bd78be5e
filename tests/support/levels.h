// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Fields on levels of samples, for tests.

#include <array>
#include <vector>

#include "fields/levels/level_field.h"
#include "fields/levels/level_files.h"

namespace pellucid::testing {

template <class T = float, class Function>
fields::Level<T> sampled(const Vec3& origin, double width, std::array<int, 3> size,
                         const Function& f) {
  fields::Level<T> level{origin, width, size, {}};
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) level.samples.push_back(T(f(level.world(Vec3(i, j, k)))));
  return level;
}

/// n³ samples.
template <class Function>
fields::ScalarLevel sampled(const Vec3& origin, double width, int n, const Function& f) {
  return sampled(origin, width, {n, n, n}, f);
}

/// [0, 8]³ in cells of 1, and [2, 6]³ in cells of a half.
template <class Function>
std::vector<fields::ScalarLevel> nested(const Function& f) {
  return {sampled(Vec3(0.5), 1, 8, f), sampled(Vec3(2.25), 0.5, 8, f)};
}

/// The levels of a file whose samples are floats.
inline std::vector<fields::ScalarLevel> read_float_levels(const std::filesystem::path& path,
                                                          std::string_view scalar,
                                                          const std::string& velocity = {}) {
  return std::get<std::vector<fields::ScalarLevel>>(
      fields::read_levels(path, scalar, velocity).levels);
}

}  // namespace pellucid::testing
