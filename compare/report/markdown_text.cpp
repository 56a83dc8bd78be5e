// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/markdown_text.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid::compare {

std::string markdown_escaped(std::string_view text) {
  std::string escaped;
  for (const char c : one_line(text, text.size() + 1))
    escaped += c == '|' ? "\\|" : c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return escaped;
}

std::string markdown_cells(std::span<const std::string> cells) {
  std::string line = "|";
  for (const std::string& cell : cells)
    line += cell.empty() ? " |" : fmt::format(" {} |", markdown_escaped(cell));
  return line + '\n';
}

std::string markdown_head(std::span<const std::string> titles, std::size_t names) {
  std::string rule = "|";
  for (std::size_t k = 0; k < titles.size(); ++k) rule += k < names ? "---|" : "---:|";
  return markdown_cells(titles) + rule + '\n';
}

std::string markdown_heading(std::string_view marks, std::string_view text) {
  return fmt::format("\n{} {}\n", marks, markdown_escaped(text));
}

}  // namespace pellucid::compare
