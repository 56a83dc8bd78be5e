// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns the text with what HTML takes for marks escaped.
std::string html_escaped(std::string_view text);

}  // namespace pellucid::compare
