// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "groundtruth/rays/crossing.h"

namespace pellucid::groundtruth {

/// Sorts crossings as operator< of Crossing orders. Depths that are spread are first dealt into as
/// many buckets as there are crossings, so that each is sorted among few: linear for the layers of
/// a usual ray, n log n at worst.
void order_crossings(std::span<Crossing> crossings);

/// Calls settle(run) for every run of sorted crossings, front to back, that overlap within
/// their errors, or where the first reaches back to depth 0.
template <class Error, class Settle>
void settle_overlaps(std::span<Crossing> crossings, const Error& error, const Settle& settle) {
  thread_local std::vector<double> reaches, begins;  // so far from the front, and from the back
  const std::size_t n = crossings.size();
  reaches.resize(n);
  begins.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double e = error(crossings[i]);
    reaches[i] = std::max(i > 0 ? reaches[i - 1] : 0, crossings[i].depth + e);
    begins[i] = crossings[i].depth - e;
  }
  for (std::size_t i = n - 1; i > 0; --i) begins[i - 1] = std::min(begins[i - 1], begins[i]);
  for (std::size_t begin = 0, end; begin < n; begin = end) {
    for (end = begin + 1; end < n && begins[end] <= reaches[end - 1];) ++end;
    if (end > begin + 1 || begins[begin] <= 0) settle(crossings.subspan(begin, end - begin));
  }
}

/// Settles the order of crossings that order_crossings() has sorted: those whose depths, within
/// their error(crossing), overlap with another one's, or with 0, get the depth
/// exact_depth(crossing) and are sorted again. So the order is that of exact depths, at a price for
/// few. Errors are at most most_doubt / 2; they are asked for where crossings are nearer than that
/// to each other.
template <class Error, class ExactDepth>
void settle_order(std::span<Crossing> crossings, double most_doubt, const Error& error,
                  const ExactDepth& exact_depth) {
  const auto is_near = [&](std::size_t i) {
    return crossings[i].depth - (i > 0 ? crossings[i - 1].depth : 0) <= most_doubt;
  };
  bool any = false;
  for (std::size_t i = 0; i < crossings.size(); ++i) any |= is_near(i);
  if (!any) return;
  const auto settle = [&](std::span<Crossing> run) {
    for (Crossing& crossing : run) crossing.depth = exact_depth(crossing);
    order_crossings(run);
  };
  for (std::size_t begin = 0, end; begin < crossings.size(); begin = end) {
    const bool near_the_eye = begin == 0 && is_near(0);
    for (end = begin + 1; end < crossings.size() && is_near(end);) ++end;
    if (near_the_eye || end > begin + 1)
      settle_overlaps(crossings.subspan(begin, end - begin), error, settle);
  }
}

}  // namespace pellucid::groundtruth
