// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files/color_names.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pellucid::geometry {
namespace {

constexpr std::array<const char*, 4> channels{"red", "green", "blue", "alpha"};
constexpr std::array<const char*, 4> families[] = {
    channels,
    {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
    {"r", "g", "b", "a"}};

std::string small(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

}  // namespace

std::map<std::string, std::string> color_channels(const std::vector<std::string>& names) {
  std::map<std::string, std::string> by_small;  // the last of names that differ in capitals alone
  for (const std::string& name : names) by_small[small(name)] = name;
  std::map<std::string, std::string> found;
  for (const auto& family : families) {
    if (!std::all_of(family.begin(), family.begin() + 3,
                     [&](const char* name) { return by_small.contains(name); }))
      continue;
    for (std::size_t c = 0; c < 4; ++c)
      if (by_small.contains(family[c])) found[by_small[family[c]]] = channels[c];
    return found;
  }
  if (by_small.contains("alpha")) found[by_small["alpha"]] = "alpha";
  return found;
}

bool is_color_name(std::string_view name) {
  const std::string text = small(name);
  return text == "rgb" || text == "rgba" || text.find("color") != text.npos ||
         text.find("colour") != text.npos;
}

}  // namespace pellucid::geometry
