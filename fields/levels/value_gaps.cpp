// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/levels/value_gaps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pellucid::fields {
namespace {

std::string digits(double value) {
  const float rounded = float(value);
  return rounded == value ? fmt::format("{}", rounded) : fmt::format("{}", value);
}

}  // namespace

void ValueGaps::add(double low, double high) {
  if (!(low < high)) return;
  const auto first = std::ranges::lower_bound(gaps_, low, {}, &Vec2::y);
  if (first != gaps_.end() && first->x <= low && high <= first->y) return;
  const auto last = std::ranges::upper_bound(first, gaps_.end(), high, {}, &Vec2::x);
  if (first == last) {
    gaps_.insert(first, Vec2(low, high));
    return;
  }
  *first = {std::min(low, first->x), std::max(high, std::prev(last)->y)};
  gaps_.erase(std::next(first), last);
}

void ValueGaps::add(const ValueGaps& others) {
  for (const Vec2& gap : others.gaps_) add(gap.x, gap.y);
}

bool ValueGaps::contains(double value) const {
  const auto gap = std::ranges::lower_bound(gaps_, value, {}, &Vec2::y);
  return gap != gaps_.end() && gap->x < value;
}

std::string ValueGaps::accepted(const Vec2& range) const {
  std::vector<std::string> parts;
  double begin = range.x;
  bool open = false;
  const auto take_to = [&](double end) {
    if (begin < end || gaps_.empty())
      parts.push_back(
          fmt::format("{} {} to {}", open ? "above" : "from", digits(begin), digits(end)));
  };
  for (const Vec2& gap : gaps_) {
    take_to(std::min(gap.x, range.y));
    if (gap.y >= begin) begin = gap.y, open = true;
  }
  take_to(range.y);
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, " or "));
}

}  // namespace pellucid::fields
