// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns a text, which a file may hold, as Markdown prints it: one line, no cell of its own, no
/// HTML.
std::string markdown_escaped(std::string_view text);

/// Returns a line of a table, whose cells are escaped; emphasis by asterisks is left.
std::string markdown_cells(std::span<const std::string> cells);

/// Returns the head of a table of these titles, and the rule below it: the first `names` columns
/// are texts, which begin at the left, the others numbers.
std::string markdown_head(std::span<const std::string> titles, std::size_t names);

/// Returns a heading of so many marks after an empty line, escaped.
std::string markdown_heading(std::string_view marks, std::string_view text);

}  // namespace pellucid::compare
