// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/json_text.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace pellucid {
namespace {

using ::testing::HasSubstr;

std::string complaint_of(const std::string& text) {
  try {
    parse_json("a.json", text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(UnitJsonText, ComplaintsNameFileAndPlace) {
  EXPECT_THAT(complaint_of("{\n  \"a\" 1}"), HasSubstr("a.json: parse error at line 2, column 7"));
  EXPECT_THAT(complaint_of(""), HasSubstr("a.json: parse error"));
  EXPECT_THAT(complaint_of("\"\xC3\""), HasSubstr("a.json: parse error"));
}

TEST(UnitJsonText, ANumberThatNoDoubleHoldsIsRefused) {
  EXPECT_THAT(complaint_of("[1e999]"), HasSubstr("1e999"));
  EXPECT_EQ(complaint_of("[1e308, -1e-400, 9223372036854775807]"), "accepted");
}

TEST(UnitJsonText, AKeyThatIsThereTwiceIsRefused) {
  EXPECT_THAT(complaint_of(R"({"fov": 45, "up": [0, 1, 0], "fov": 50})"), HasSubstr("'fov'"));
  EXPECT_EQ(complaint_of(R"([{"a": {"a": 1}}, {"a": 2, "b": {"a": 3}}])"), "accepted");
  EXPECT_THAT(complaint_of(R"({"a": {"b": 1}, "c": {"d": {}, "d": 1}})"), HasSubstr("'d'"));
}

TEST(UnitJsonText, NestingIsBounded) {
  const auto nested = [](int levels) {
    return std::string(std::size_t(levels), '[') + std::string(std::size_t(levels), ']');
  };
  EXPECT_EQ(complaint_of(nested(90)), "accepted");
  EXPECT_THAT(complaint_of(nested(100000)), HasSubstr("100 levels deep"));
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_THAT(complaint_of(objects), HasSubstr("100 levels deep"));
}

TEST(UnitJsonText, NothingIsPassedOverBehindANul) {
  using namespace std::string_literals;
  EXPECT_THAT(complaint_of("{}\0{{{"s), HasSubstr("a.json: byte 2 is 0"));
  EXPECT_EQ(complaint_of("{}\0\0\0"s), "accepted");
  EXPECT_THAT(complaint_of(R"({"mesh": "a.ply\u0000.ply"})"), HasSubstr("\\u0000"));
  EXPECT_THAT(complaint_of(R"({"a\u0000": 1})"), HasSubstr("\\u0000"));
}

TEST(UnitJsonText, BytesThatAreNoTextAreWrittenAsSuch) {
  EXPECT_EQ(json_text({{"file", "\xFF.ply"}}), "{\"file\":\"\uFFFD.ply\"}");
}

}  // namespace
}  // namespace pellucid
