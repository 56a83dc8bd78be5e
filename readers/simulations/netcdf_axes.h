// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>

namespace pellucid::readers {

/// AxisOrder says of each axis of a grid, the fastest first, which axis of space it runs along: a
/// permutation of 0 to 2.
using AxisOrder = std::array<int, 3>;

/// Returns a variable's attribute of text, without the zero that may end it; "" where there is
/// none.
std::string text_attribute(int file, int variable, const char* name);

/// Returns which axes of space up to three dimensions of an open file run along, the first being
/// the fastest. The coordinate of a dimension says it by the attributes of the CF conventions:
/// axis, standard_name, units, positive; one without these by its name, where that is a usual one
/// (x, lon, lat, depth, …). Others have the place that is theirs by their order, or the first that
/// is left; all have, where two are said to be one axis.
AxisOrder axis_order(int file, std::span<const int> dimensions);

}  // namespace pellucid::readers
