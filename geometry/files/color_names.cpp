// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/color_names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/options/lower_case.h"

namespace pellucid::geometry {
namespace {

constexpr std::array<const char*, 4> rgba{"red", "green", "blue", "alpha"};
constexpr std::array<const char*, 4> families[] = {
    rgba, {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"}, {"r", "g", "b", "a"}};

}  // namespace

std::map<std::string, std::string> color_channels(const std::vector<std::string>& names) {
  std::map<std::string, std::string> by_small;  // the last of names that differ in capitals alone
  for (const std::string& name : names) by_small[lower_case(name)] = name;
  std::map<std::string, std::string> found;
  for (const auto& family : families) {
    if (!std::all_of(family.begin(), family.begin() + 3,
                     [&](const char* name) { return by_small.contains(name); }))
      continue;
    for (std::size_t c = 0; c < 4; ++c)
      if (by_small.contains(family[c])) found[by_small[family[c]]] = rgba[c];
    // "diffuse_red, …, alpha": of no other name, it would be one that counts as it stands.
    if (!by_small.contains(family[3]) && by_small.contains("alpha"))
      found[by_small["alpha"]] = "alpha";
    return found;
  }
  if (by_small.contains("alpha")) found[by_small["alpha"]] = "alpha";
  return found;
}

std::vector<std::string> untaken_colors(const std::vector<std::string>& scalars) {
  const std::set<std::string_view> names(scalars.begin(), scalars.end());
  std::set<std::string> found;
  for (const std::string_view name : names) {
    if (!name.ends_with("_x")) continue;
    const std::string stem(name.substr(0, name.size() - 2));
    if (is_color_name(stem) && names.contains(stem + "_y") && names.contains(stem + "_z"))
      found.insert(stem);
  }
  if (const auto channels = color_channels(scalars); channels.size() >= 3) {
    std::vector<std::string> of_family(4);
    for (const auto& [name, channel] : channels)
      of_family[std::size_t(std::ranges::find(rgba, channel) - rgba.begin())] = name;
    if (of_family[3].empty()) of_family.pop_back();
    found.insert(fmt::format("{}", fmt::join(of_family, " ")));
  }
  return {found.begin(), found.end()};
}

bool is_color_name(std::string_view name) {
  const std::string text = lower_case(name);
  return text == "rgb" || text == "rgba" || text.find("color") != text.npos ||
         text.find("colour") != text.npos;
}

}  // namespace pellucid::geometry
