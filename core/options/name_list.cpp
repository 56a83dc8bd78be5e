// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/name_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace pellucid {

std::string some_of(std::span<const std::string> names, std::size_t most) {
  const auto shown = names.first(std::min(names.size(), most));
  const std::string text = fmt::format("{}", fmt::join(shown, ", "));
  return names.size() == shown.size()
             ? text
             : fmt::format("{} and {} more", text, names.size() - shown.size());
}

}  // namespace pellucid
