// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "compare/figure/figure_sheet.h"

namespace pellucid::compare {

/// Returns the text, which ends with an ellipsis where all of it would be wider than `width`, in
/// points. Control characters and bytes that are no UTF-8 are as one_line() has them.
std::string fitted(const std::string& text, double size, double width, const TextRuler& ruler);

/// Breaks a text at its spaces into lines no wider than `width`; the last of `most` lines is
/// fitted() to what is left.
std::vector<std::string> wrapped(const std::string& text, double size, double width,
                                 std::size_t most, const TextRuler& ruler);

}  // namespace pellucid::compare
