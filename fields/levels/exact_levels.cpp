// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/exact_levels.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace pellucid::fields {
namespace {

bool is_float(double sample) { return float(sample) == sample; }

/// The level with what `convert` makes of its samples, whose own are given back.
template <class To, class From, class Convert>
Level<To> converted(Level<From>& level, const Convert& convert) {
  Level<To> out{level.origin, level.width, level.size, {}};
  out.samples.reserve(level.samples.size());
  for (const From sample : level.samples) out.samples.push_back(To(convert(sample)));
  level.samples = {};
  return out;
}

template <class To, class From, class Convert>
std::vector<Level<To>> converted(std::vector<Level<From>>& levels, const Convert& convert) {
  std::vector<Level<To>> out;
  for (Level<From>& level : levels) out.push_back(converted<To>(level, convert));
  return out;
}

constexpr auto itself = [](auto sample) { return sample; };

std::vector<DoubleLevel> in_doubles(ExactLevels levels) {
  if (auto* doubles = std::get_if<std::vector<DoubleLevel>>(&levels)) return std::move(*doubles);
  return converted<double>(std::get<std::vector<ScalarLevel>>(levels), itself);
}

}  // namespace

ExactLevels exact(std::vector<DoubleLevel> levels) {
  if (std::ranges::all_of(
          levels, [](const auto& level) { return std::ranges::all_of(level.samples, is_float); }))
    return converted<float>(levels, itself);
  return levels;
}

void append(ExactLevels more, ExactLevels& levels) {
  if (more.index() != levels.index()) {
    more = in_doubles(std::move(more));
    levels = in_doubles(std::move(levels));
  }
  std::visit(
      [&](auto& all) {
        std::ranges::move(std::get<std::remove_reference_t<decltype(all)>>(more),
                          std::back_inserter(all));
      },
      levels);
}

bool is_empty(const ExactLevels& levels) {
  return std::visit([](const auto& all) { return all.empty(); }, levels);
}

Vec2 sample_range(const ExactLevels& levels) {
  Vec2 range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  std::visit(
      [&](const auto& all) {
        for (const auto& level : all)
          if (const auto [low, high] = std::ranges::minmax_element(level.samples);
              low != level.samples.end())
            range = {std::min(range.x, double(*low)), std::max(range.y, double(*high))};
      },
      levels);
  return range;
}

std::vector<double> samples_of(const ExactLevels& levels) {
  std::vector<double> samples;
  std::visit(
      [&](const auto& all) {
        for (const auto& level : all)
          samples.insert(samples.end(), level.samples.begin(), level.samples.end());
      },
      levels);
  return samples;
}

ScaledLevels rounded(ExactLevels levels, double about) {
  if (auto* floats = std::get_if<std::vector<ScalarLevel>>(&levels))
    return {std::move(*floats), {}};
  const Vec2 range = sample_range(levels);
  const SampleScale scale(about, range.x, range.y);
  return {converted<float>(std::get<std::vector<DoubleLevel>>(levels),
                           [&](double sample) { return scale.kept(sample); }),
          scale};
}

}  // namespace pellucid::fields
