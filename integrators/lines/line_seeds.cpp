// SPDX-License-Identifier: GPL-3.0-or-later
#include "integrators/lines/line_seeds.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/parallel.h"

namespace pellucid::integrators {
namespace {

constexpr int first_intervals = 64, rounds = 6;
constexpr double evenly = 0.1;  // part of the lines

using Importance = std::function<double(double)>;

struct Sample {
  double s, importance;
};

/// Of the interval that ends at sample i.
double mass(const std::vector<Sample>& samples, std::size_t i) {
  return 0.5 * (samples[i].importance + samples[i - 1].importance) *
         (samples[i].s - samples[i - 1].s);
}

// Halves the half of the intervals in which most of the importance lies.
void bisect(std::vector<Sample>& samples, const Importance& importance) {
  std::vector<std::size_t> order(samples.size() - 1);
  std::iota(order.begin(), order.end(), std::size_t(1));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return mass(samples, a) > mass(samples, b);
  });
  order.resize(std::max<std::size_t>(order.size() / 2, 1));
  std::vector<Sample> middles(order.size());
  parallel_for(std::size_t(0), order.size(), [&](std::size_t k) {
    const double s = 0.5 * (samples[order[k] - 1].s + samples[order[k]].s);
    middles[k] = {s, importance(s)};
  });
  samples.insert(samples.end(), middles.begin(), middles.end());
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.s < b.s; });
}

}  // namespace

LineSeeds::LineSeeds() : s_{0, 1}, fraction_{0, 1} {}

LineSeeds::LineSeeds(const Importance& importance) : LineSeeds() {
  std::vector<Sample> samples(first_intervals + 1);
  parallel_for(0, first_intervals + 1, [&](int i) {
    const double s = double(i) / first_intervals;
    samples[i] = {s, importance(s)};
  });
  for (int round = 0; round < rounds; ++round) bisect(samples, importance);
  std::vector<double> sums{0};
  for (std::size_t i = 1; i < samples.size(); ++i) sums.push_back(sums.back() + mass(samples, i));
  if (!(sums.back() > 0) || !std::isfinite(sums.back())) return;
  s_.clear(), fraction_.clear();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    s_.push_back(samples[i].s);
    fraction_.push_back(evenly * samples[i].s + (1 - evenly) * sums[i] / sums.back());
  }
}

LineSeeds::Seed LineSeeds::seed(std::uint64_t line) const {
  const double turns = double(line + 1) / std::numbers::phi;
  const double u = turns - std::floor(turns);
  const auto after =
      std::upper_bound(fraction_.begin() + 1, fraction_.end() - 1, u) - fraction_.begin();
  const double length = s_[after] - s_[after - 1], part = fraction_[after] - fraction_[after - 1];
  return {s_[after - 1] + length * (u - fraction_[after - 1]) / part, part / length};
}

}  // namespace pellucid::integrators
