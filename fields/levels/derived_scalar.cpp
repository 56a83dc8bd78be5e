// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars of a sampled velocity. The Q-criterion is that of Li and Chen, Multi-Resolution
// Isosurface Rendering (2023), Eq. 1 (J. C. R. Hunt, A. A. Wray, P. Moin, CTR-S88 (1988)): for a
// flow without divergence, half of |Ω|² - |S|². As there, derivatives inside a level are central
// differences. At the level's faces they are one-sided, (-3f₀ + 4f₁ - f₂)/2h, also of second order:
// the report reads whatever its grid holds beyond its active voxels, which wraps every level in a
// false shell.
#include "fields/levels/derived_scalar.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/options/names.h"
#include "core/parallel.h"
#include "fields/levels/level_blocks.h"

namespace pellucid::fields {
namespace {

/// In the numbers that the velocity has, computed in doubles.
template <class T, class Compute>
Level<T> for_each_sample(const Level<glm::vec<3, T>>& v, const Compute& compute) {
  Level<T> out{v.origin, v.width, v.size, std::vector<T>(v.samples.size())};
  parallel_for(0, v.size[2], [&](int k) {
    for (int j = 0; j < v.size[1]; ++j)
      for (int i = 0; i < v.size[0]; ++i) out.samples[v.index(i, j, k)] = T(compute(i, j, k));
  });
  return out;
}

/// The derivative along the axis whose samples are `stride` apart, times the cell width.
template <class Sample>
Vec3 difference(const Sample* at, int i, int n, std::ptrdiff_t stride) {
  const auto f = [&](std::ptrdiff_t step) { return Vec3(at[step * stride]); };
  if (i == 0) return 0.5 * (-3.0 * f(0) + 4.0 * f(1) - f(2));
  if (i == n - 1) return 0.5 * (3.0 * f(0) - 4.0 * f(-1) + f(-2));
  return 0.5 * (f(1) - f(-1));
}

template <class T>
Level<T> magnitude(const Level<glm::vec<3, T>>& v) {
  return for_each_sample(v, [&](int i, int j, int k) { return glm::length(Vec3(v.at(i, j, k))); });
}

template <class T>
Level<T> q_criterion(const Level<glm::vec<3, T>>& v) {
  const std::ptrdiff_t row = v.size[0], slice = row * v.size[1];
  const double scale = 1 / (v.width * v.width);
  return for_each_sample(v, [&](int i, int j, int k) {
    const auto* at = &v.at(i, j, k);
    const Vec3 x = difference(at, i, v.size[0], 1), y = difference(at, j, v.size[1], row),
               z = difference(at, k, v.size[2], slice);
    const double diagonal = x.x * x.x + y.y * y.y + z.z * z.z;
    return scale * (-0.5 * diagonal - y.x * x.y - z.x * x.z - z.y * y.z);
  });
}

constexpr DerivedScalarRow rows[] = {
    {"magnitude", "Speed |v|", "Li, Chen 2023, Sect. 3.1", magnitude<float>, magnitude<double>},
    {"speed", "Speed |v|, by the name that lines give it", "", magnitude<float>, magnitude<double>},
    {"q", "Q-criterion", "Li, Chen 2023, Eq. 1; Hunt, Wray, Moin 1988", q_criterion<float>,
     q_criterion<double>}};

}  // namespace

std::span<const DerivedScalarRow> derived_scalars() { return rows; }

const DerivedScalarRow& find_derived_scalar(std::string_view name) {
  return find_row("scalar", name, rows);
}

namespace {

template <class T, class Compute>
std::vector<Level<T>> computed(std::span<const Level<glm::vec<3, T>>> levels,
                               const Compute& compute) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    check_level(fmt::format("level {}", i), levels[i]);
  std::vector<Level<T>> scalars;
  for (const auto& level : joined_blocks(std::vector(levels.begin(), levels.end())))
    scalars.push_back(compute(level));
  return scalars;
}

}  // namespace

std::vector<ScalarLevel> scalars_of(std::span<const VectorLevel> levels, std::string_view name) {
  return computed(levels, find_derived_scalar(name).compute);
}
std::vector<DoubleLevel> scalars_of(std::span<const DoubleVectorLevel> levels,
                                    std::string_view name) {
  return computed(levels, find_derived_scalar(name).compute_exactly);
}

bool is_derived(std::string_view scalar) {
  return std::ranges::any_of(rows, [&](const auto& row) { return row.name == scalar; });
}

}  // namespace pellucid::fields
