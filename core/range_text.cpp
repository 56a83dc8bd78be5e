// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/range_text.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace pellucid {

std::array<std::string, 2> range_ends(double low, double high) {
  constexpr int fewest = 6, most = 17;  // digits; with 17 every double is itself
  const double wanted = 0.01 * std::abs(high - low);
  const auto is_right = [&](const std::string& text, double value) {
    return std::abs(std::strtod(text.c_str(), nullptr) - value) <= wanted;
  };
  std::array<std::string, 2> ends;
  for (int digits = fewest; digits <= most; ++digits) {
    ends = {fmt::format("{:.{}g}", low, digits), fmt::format("{:.{}g}", high, digits)};
    if (!(low != high) || (is_right(ends[0], low) && is_right(ends[1], high))) break;
  }
  return ends;
}

std::string range_text(double low, double high) {
  const auto ends = range_ends(low, high);
  return ends[0] + " … " + ends[1];
}

}  // namespace pellucid
