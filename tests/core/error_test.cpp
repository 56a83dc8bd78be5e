// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace pellucid {
namespace {

TEST(UnitOneLine, OrdinaryTextStaysAsItIs) {
  EXPECT_EQ(one_line("sheet.ply:812: α is 1.5; accepted: 0 … 1"),
            "sheet.ply:812: α is 1.5; accepted: 0 … 1");
  EXPECT_EQ(one_line(""), "");
  EXPECT_EQ(one_line("ends with a line break\n"), "ends with a line break");
}

TEST(UnitOneLine, ControlCharactersBecomeEscapes) {
  EXPECT_EQ(one_line("a\nb\tc\rd"), "a\\nb\\tc\\rd");
  EXPECT_EQ(one_line(std::string_view("\x1b[31m\0", 6)), "\\x1b[31m\\x00");
  EXPECT_EQ(one_line("\xC2\x85"), "\\x85");                             // next line, U+0085
  EXPECT_EQ(one_line("\xE2\x80\xA8x\xE2\x80\xAE"), "\\u2028x\\u202e");  // line separator, override
}

TEST(UnitOneLine, WhatIsNoUtf8IsReplaced) {
  const std::string r = "\uFFFD";
  EXPECT_EQ(one_line("a\xFF"), "a" + r);
  EXPECT_EQ(one_line("\xC3"), r);                          // cut inside a character
  EXPECT_EQ(one_line("\xC0\xAF"), r + r);                  // overlong
  EXPECT_EQ(one_line("\xED\xA0\x80"), r + r + r);          // a surrogate
  EXPECT_EQ(one_line("\xF4\x90\x80\x80"), r + r + r + r);  // beyond U+10FFFF
  EXPECT_EQ(one_line("\xF0\x9F\x98\x80"), "\xF0\x9F\x98\x80");
}

std::size_t characters(const std::string& text) {
  return std::size_t(
      std::ranges::count_if(text, [](char c) { return (std::uint8_t(c) & 0xC0) != 0x80; }));
}

TEST(UnitOneLine, IsCutBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 500; ++i) text += "ä";
  const std::string cut = one_line(text);
  EXPECT_EQ(characters(cut), longest_message);
  EXPECT_TRUE(cut.ends_with("ä…"));
  EXPECT_EQ(one_line(text.substr(0, 2 * longest_message)), text.substr(0, 2 * longest_message));
}

/// Of any bytes: one line, valid, bounded; and doing it again changes nothing.
TEST(PropertyOneLine, IsItsOwnFixedPoint) {
  std::mt19937 random(5);
  for (int run = 0; run < 2000; ++run) {
    std::string bytes(random() % 700, '\0');
    const std::uint32_t highest = run % 2 ? 256 : 0x40;
    for (char& byte : bytes) byte = char(random() % highest);
    const std::string line = one_line(bytes);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_LE(characters(one_line(line)), longest_message);
    if (characters(line) < longest_message) {
      EXPECT_EQ(one_line(line), line);
    }
  }
}

TEST(UnitErrors, CarryOneLine) {
  EXPECT_STREQ(InputError("a\nb").what(), "a\\nb");
  EXPECT_STREQ(WorkError("a\nb").what(), "a\\nb");
}

}  // namespace
}  // namespace pellucid
