// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars of a sampled velocity. The Q-criterion is that of Li and Chen, Multi-Resolution
// Isosurface Rendering (2023), Eq. 1 (J. C. R. Hunt, A. A. Wray, P. Moin, CTR-S88 (1988)): for a
// flow without divergence, half of |Ω|² - |S|². As there, derivatives inside a level are central
// differences. At the level's faces they are one-sided, (-3f₀ + 4f₁ - f₂)/2h, also of second order:
// the report reads whatever its grid holds beyond its active voxels, which wraps every level in a
// false shell.
#include "fields/levels/derived_scalar.h"

#include <fmt/format.h>

#include "core/options/names.h"
#include "core/parallel.h"
#include "fields/levels/level_blocks.h"

namespace pellucid::fields {
namespace {

template <class Compute>
ScalarLevel for_each_sample(const VectorLevel& v, const Compute& compute) {
  ScalarLevel out{v.origin, v.width, v.size, std::vector<float>(v.samples.size())};
  parallel_for(0, v.size[2], [&](int k) {
    for (int j = 0; j < v.size[1]; ++j)
      for (int i = 0; i < v.size[0]; ++i) out.samples[v.index(i, j, k)] = float(compute(i, j, k));
  });
  return out;
}

/// The derivative along the axis whose samples are `stride` apart, times the cell width.
Vec3 difference(const glm::vec3* at, int i, int n, std::ptrdiff_t stride) {
  const auto f = [&](std::ptrdiff_t step) { return Vec3(at[step * stride]); };
  if (i == 0) return 0.5 * (-3.0 * f(0) + 4.0 * f(1) - f(2));
  if (i == n - 1) return 0.5 * (3.0 * f(0) - 4.0 * f(-1) + f(-2));
  return 0.5 * (f(1) - f(-1));
}

ScalarLevel magnitude(const VectorLevel& v) {
  return for_each_sample(v, [&](int i, int j, int k) { return glm::length(Vec3(v.at(i, j, k))); });
}

ScalarLevel q_criterion(const VectorLevel& v) {
  const std::ptrdiff_t row = v.size[0], slice = row * v.size[1];
  const double scale = 1 / (v.width * v.width);
  return for_each_sample(v, [&](int i, int j, int k) {
    const glm::vec3* at = &v.at(i, j, k);
    const Vec3 x = difference(at, i, v.size[0], 1), y = difference(at, j, v.size[1], row),
               z = difference(at, k, v.size[2], slice);
    const double diagonal = x.x * x.x + y.y * y.y + z.z * z.z;
    return scale * (-0.5 * diagonal - y.x * x.y - z.x * x.z - z.y * y.z);
  });
}

constexpr DerivedScalarRow rows[] = {
    {"magnitude", "Speed |v|", "Li, Chen 2023, Sect. 3.1", magnitude},
    {"speed", "Speed |v|, by the name that lines give it", "", magnitude},
    {"q", "Q-criterion", "Li, Chen 2023, Eq. 1; Hunt, Wray, Moin 1988", q_criterion}};

}  // namespace

std::span<const DerivedScalarRow> derived_scalars() { return rows; }

const DerivedScalarRow& find_derived_scalar(std::string_view name) {
  return find_row("scalar", name, rows);
}

std::vector<ScalarLevel> scalars_of(std::span<const VectorLevel> levels, std::string_view name) {
  const DerivedScalarRow& row = find_derived_scalar(name);
  for (std::size_t i = 0; i < levels.size(); ++i)
    check_level(fmt::format("level {}", i), levels[i]);
  std::vector<ScalarLevel> scalars;
  for (const VectorLevel& level :
       joined_blocks(std::vector<VectorLevel>(levels.begin(), levels.end())))
    scalars.push_back(row.compute(level));
  return scalars;
}

}  // namespace pellucid::fields
