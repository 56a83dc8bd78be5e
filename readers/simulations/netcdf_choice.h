// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace pellucid::readers {

/// A NetcdfChoice is what can be chosen of a file: a variable with its dimensions but for time, as
/// VTK writes them, "(lat, lon)".
struct NetcdfChoice {
  std::string name, dimensions;
  bool is_number = true;
  std::string unread = {};    // why VTK cannot load it; "" of others
  bool time_is_late = false;  // a later dimension than the first is its time

  std::ptrdiff_t axes() const {
    return dimensions == "()" ? 0 : std::ranges::count(dimensions, ',') + 1;
  }
  bool is_grid() const { return is_number && unread.empty() && axes() > 0; }
};

/// Returns the dimensions of the variables that `wanted` names, with commas between; when it names
/// none, those of three axes before those of two, of several the ones of the most variables; "" of
/// a file without any. Throws InputError where the wanted ones differ in their dimensions, and for
/// one that cannot be loaded, wanted or the only one.
std::string chosen_dimensions(const std::vector<NetcdfChoice>& choices, const std::string& wanted,
                              const std::string& file);

}  // namespace pellucid::readers
