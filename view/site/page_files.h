// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "view/site/exchange.h"

namespace pellucid::view {

/// Returns a part of the page that turns a scene: "" is its HTML, "view.css" and "view.js" what it
/// loads. Nothing for another name.
std::optional<Answer> page_file(std::string_view name);

}  // namespace pellucid::view
