// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/times.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/options/parameters.h"

namespace pellucid::readers {

std::size_t chosen_time(std::span<const double> times, const std::string& wanted,
                        const std::filesystem::path& path) {
  constexpr double rounding = 1e-6;  // programs print times with six digits or more
  if (times.empty())
    throw InputError(fmt::format("{}: time={}: it has no times", path.string(), wanted));
  if (wanted == "first") return 0;
  if (wanted == "last") return times.size() - 1;
  double time = 0;
  if (parse_number(wanted, time))
    for (std::size_t i = 0; i < times.size(); ++i)
      if (std::abs(times[i] - time) <= rounding * std::max(std::abs(times[i]), std::abs(time)))
        return i;
  throw InputError(
      fmt::format("{}: time={}; accepted: first, last, or one of its {} times from {} to {}",
                  path.string(), wanted, times.size(), times.front(), times.back()));
}

}  // namespace pellucid::readers
