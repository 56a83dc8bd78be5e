// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace pellucid::geometry {

/// Returns what a component adds to its array's name: "_x" of a vector, "_xy" of a tensor,
/// symmetric ones in the order of VTK 9, else its number, "_7".
std::string component_suffix(std::size_t component, std::size_t components);

}  // namespace pellucid::geometry
