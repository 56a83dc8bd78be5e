// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace pellucid {
namespace {

constexpr std::string_view replacement = "\uFFFD", ellipsis = "…";

struct Character {
  char32_t code = 0;
  std::size_t length = 0;  // in bytes; 0: no UTF-8
};

/// The character that `text` begins with. Overlong forms, surrogates and what lies beyond U+10FFFF
/// are no UTF-8 (RFC 3629, section 3).
Character first_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return std::uint8_t(text[i]); };
  if (byte(0) < 0x80) return {byte(0), 1};
  const std::size_t length = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
  if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < length) return {};
  char32_t code = byte(0) & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return {};
    code = code << 6 | (byte(i) & 0x3F);
  }
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < least[length] || code > 0x10FFFF || is_surrogate) return {};
  return {code, length};
}

/// Control characters, and those that turn or break a line (U+2028, U+2029, bidirectional marks).
bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x2028 || code == 0x2029 ||
         (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string escaped(char32_t code) {
  if (code == '\n') return "\\n";
  if (code == '\t') return "\\t";
  if (code == '\r') return "\\r";
  return code < 0x100 ? fmt::format("\\x{:02x}", std::uint32_t(code))
                      : fmt::format("\\u{:04x}", std::uint32_t(code));
}

}  // namespace

std::string one_line(std::string_view text, std::size_t most) {
  while (text.ends_with('\n')) text.remove_suffix(1);
  std::string line;
  for (std::size_t count = 0; !text.empty(); ++count) {
    if (count + 1 >= most && text.size() > first_character(text).length)
      return line.append(ellipsis);
    const Character character = first_character(text);
    if (character.length == 0)
      line += replacement;
    else if (is_control(character.code))
      line += escaped(character.code);
    else
      line += text.substr(0, character.length);
    text.remove_prefix(std::max<std::size_t>(character.length, 1));
  }
  return line;
}

}  // namespace pellucid
