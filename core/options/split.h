// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

namespace pellucid {

/// Returns the parts of `text` between separators, empty ones included: n separators part n + 1. An
/// empty text has one part, which is empty. The parts are views into `text`.
std::vector<std::string_view> split(std::string_view text, char separator);

/// Splits likewise, but at no separator within parentheses, so that a part may be a formula.
std::vector<std::string_view> split_outside_parentheses(std::string_view text, char separator);

}  // namespace pellucid
