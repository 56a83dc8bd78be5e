// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/options/split.h"

namespace pellucid {
namespace {

/// Parts at the separators for which `counts(place)` holds; it is asked for every place in order.
template <class Counts>
std::vector<std::string_view> parts_of(std::string_view text, Counts counts) {
  std::vector<std::string_view> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (counts(i)) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
  parts.push_back(text.substr(begin));
  return parts;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
  return parts_of(text, [&](std::size_t i) { return text[i] == separator; });
}

std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator) {
  return parts_of(text, [&, depth = 0](std::size_t i) mutable {
    depth += (text[i] == '(') - (text[i] == ')');
    return text[i] == separator && depth == 0;
  });
}

}  // namespace pellucid
