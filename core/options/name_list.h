// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace pellucid {

/// Returns the first `most` names and how many more there are: "a, b, c and 4 more".
std::string some_of(std::span<const std::string> names, std::size_t most = 3);

}  // namespace pellucid
