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

/// Returns the dimension along which a variable of an open file has its places one by one, where
/// its attribute `coordinates` names a longitude and a latitude along that dimension alone, as on
/// unstructured grids; "" where it names none.
std::string dimension_of_listed_places(int file, int variable);

/// Returns which axes of space up to three dimensions of an open file run along, the first being
/// the fastest. The coordinate of a dimension says it by the attributes of the CF conventions:
/// axis, standard_name, units, positive; one without these by its name, where that is a usual one
/// (x, lon, lat, depth, …). Others have the place that is theirs by their order, or the first that
/// is left; all have, where two are said to be one axis.
AxisOrder axis_order(int file, std::span<const int> dimensions);

}  // namespace pellucid::readers
