// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/files/periods.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "core/options/parameters.h"
#include "core/options/split.h"

namespace pellucid::fields {

Periods parse_periods(std::string_view text, const std::string& file) {
  Periods periods;
  periods.given = !text.empty();
  if (text.empty() || text == "none") return periods;
  for (const std::string_view part : split(text, ',')) {
    const std::size_t axis = std::string_view("xyz").find(part.substr(0, 1));
    double length = 0;
    const bool has_length = part.size() > 1;
    const bool is_right = !part.empty() && axis < 3 && !periods.along[axis] &&
                          (!has_length || (part[1] == ':' && parse_number(part.substr(2), length) &&
                                           length > 0 && std::isfinite(length)));
    if (!is_right)
      throw InputError(fmt::format(
          "{}: periodic={}; accepted: none, or axes among x, y, z, each once, with a length > 0 or "
          "without: x,y or x:360",
          file, text));
    periods.along[axis] = length;
  }
  return periods;
}

}  // namespace pellucid::fields
