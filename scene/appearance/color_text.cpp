// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/appearance/color_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

#include "core/options/lower_case.h"
#include "core/options/names.h"

namespace pellucid::scene {
namespace {

struct NamedColor {
  std::string_view name;
  std::uint32_t rgb;  // 0xRRGGBB
};

constexpr NamedColor named_colors[] = {
#include "scene/appearance/css_colors.inc"
};

Vec3 channels(std::uint32_t rgb) {
  return Vec3(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0;
}

std::optional<std::uint32_t> hexadecimal(std::string_view digits) {
  std::uint32_t value = 0;
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

/// Each digit of "#rgb" stands for two.
std::string doubled(std::string_view digits) {
  std::string all;
  for (const char digit : digits) all.append(2, digit);
  return all;
}

constexpr std::string_view with_opacity = "#rrggbb, #rgb, #rrggbbaa, #rgba",
                           without_opacity = "#rrggbb, #rgb, a name";

/// `accepted` is what a wrong text is told.
TextColor color_of_digits(std::string_view text, std::string_view accepted) {
  std::string digits(text.substr(1));
  if (digits.size() == 3 || digits.size() == 4) digits = doubled(digits);
  const auto value = digits.size() == 6 || digits.size() == 8 ? hexadecimal(digits) : std::nullopt;
  if (!value) throw InputError(fmt::format("'{}'; accepted: {}", text, accepted));
  if (digits.size() == 6) return {channels(*value), std::nullopt};
  return {channels(*value >> 8), (*value & 255) / 255.0};
}

TextColor color_of(std::string_view text, std::string_view accepted) {
  if (text.starts_with('#')) return color_of_digits(text, accepted);
  return {channels(find_row("colour", lower_case(text), named_colors).rgb), std::nullopt};
}

}  // namespace

TextColor color_of_text(std::string_view text) { return color_of(text, with_opacity); }

Vec3 rgb_of_text(std::string_view text) {
  const TextColor color = color_of(text, without_opacity);
  if (color.alpha)
    throw InputError(fmt::format("'{}' has an opacity; accepted here: {}", text, without_opacity));
  return color.rgb;
}

}  // namespace pellucid::scene
