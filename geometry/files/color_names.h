// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace pellucid::geometry {

/// Returns, of the names of a vertex's numbers, those that are its colour, with the channel that
/// each is: red, green, blue or alpha. In capital or small letters these are, the first that a file
/// has in full: red green blue; diffuse_red diffuse_green diffuse_blue (PMVS, VisualSFM); r g b.
/// With each goes its alpha, diffuse_alpha or a; an alpha alone is one, too.
std::map<std::string, std::string> color_channels(const std::vector<std::string>& names);

/// Returns, of the names of scalars, what is called as a colour is and so was not taken for one:
/// the stem of NAME_x, NAME_y, NAME_z; "r g b" of three. Sorted.
std::vector<std::string> untaken_colors(const std::vector<std::string>& scalars);

/// Says whether an array of three or four components is called as colours are: RGB, RGBA, or a
/// name with color or colour in it, in capital or small letters.
bool is_color_name(std::string_view name);

}  // namespace pellucid::geometry
