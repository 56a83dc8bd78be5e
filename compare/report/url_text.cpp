// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/url_text.h"

#include <fmt/format.h>

#include <string_view>

namespace pellucid::compare {

std::string url_of(const std::filesystem::path& path) {
  constexpr std::string_view plain = "-._~/=,+";
  std::string url;
  for (const char c : path.generic_string()) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || plain.find(c) != std::string_view::npos;
    if (is_plain)
      url += c;
    else
      url += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

}  // namespace pellucid::compare
