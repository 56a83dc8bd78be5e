// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/derived_scalar.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/options/names.h"
#include "core/parallel.h"
#include "fields/levels/level_blocks.h"
#include "fields/levels/q_criterion.h"

namespace pellucid::fields {
namespace {

template <class T>
Level<T> magnitude(const Level<glm::vec<3, T>>& v) {
  Level<T> out{v.origin, v.width, v.size, std::vector<T>(v.samples.size())};
  parallel_for(0, v.size[2], [&](int k) {
    for (std::size_t i = v.index(0, 0, k); i < v.index(0, 0, k + 1); ++i)
      out.samples[i] = T(glm::length(Vec3(v.samples[i])));
  });
  return out;
}

constexpr DerivedScalarRow rows[] = {
    {"magnitude", "Speed |v|", "Li, Chen 2023, Sect. 3.1", magnitude<float>, magnitude<double>},
    {"speed", "Speed |v|, by the name that lines give it", "", magnitude<float>, magnitude<double>},
    {"q", "Q-criterion", "Li, Chen 2023, Eq. 1; Hunt, Wray, Moin 1988", q_criterion, q_criterion}};

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
