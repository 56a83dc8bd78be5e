// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/figure/fitted_text.h"

#include <algorithm>

#include "core/error.h"

namespace pellucid::compare {
namespace {

/// How many bytes of UTF-8 begin characters.
std::size_t character_count(const std::string& text) {
  return std::size_t(
      std::ranges::count_if(text, [](char c) { return (std::uint8_t(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::string fitted(const std::string& text, double size, double width, const TextRuler& ruler) {
  std::string line = one_line(text);
  for (std::size_t most = character_count(line); most > 1 && ruler({{line}}, size) > width; --most)
    line = one_line(line, most - 1);
  return line;
}

std::vector<std::string> wrapped(const std::string& text, double size, double width,
                                 std::size_t most, const TextRuler& ruler) {
  std::vector<std::string> lines;
  std::string rest = one_line(text);
  while (!rest.empty() && lines.size() + 1 < most && ruler({{rest}}, size) > width) {
    std::size_t end = rest.rfind(' ');
    while (end != std::string::npos && end > 0 && ruler({{rest.substr(0, end)}}, size) > width)
      end = rest.rfind(' ', end - 1);
    if (end == std::string::npos || end == 0) break;
    lines.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  if (!rest.empty()) lines.push_back(fitted(rest, size, width, ruler));
  return lines;
}

}  // namespace pellucid::compare
