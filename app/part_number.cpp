// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/part_number.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/options/parameters.h"

namespace pellucid::app {
namespace {

/// 0 for what is no number from 1 to `most`.
int number_of(std::string_view text, int most) {
  double number = 0;
  const bool fits = parse_number(text, number) && number >= 1 && number <= most;
  return fits && number == int(number) ? int(number) : 0;
}

}  // namespace

scene::PartNumber part_number_of(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  scene::PartNumber part;
  part.count = slash < text.size()
                   ? number_of(std::string_view(text).substr(slash + 1), scene::most_parts)
                   : 0;
  part.part = number_of(std::string_view(text).substr(0, slash), part.count);
  if (part.count == 0 || part.part == 0)
    throw InputError(
        fmt::format("--part: '{}'; accepted: I/N, 1 <= I <= N <= {}", text, scene::most_parts));
  return part;
}

}  // namespace pellucid::app
