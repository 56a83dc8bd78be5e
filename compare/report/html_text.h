// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace pellucid::compare {

/// Returns the text with what HTML takes for marks escaped, in attributes, too.
std::string html_escaped(std::string_view text);

/// Returns the page with each {{name}} replaced by the text of that name, none of which is searched
/// for marks of its own.
std::string filled(std::string_view page, const std::map<std::string_view, std::string>& texts);

}  // namespace pellucid::compare
