// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/xml_tags.h"

#include <gtest/gtest.h>

#include <random>

namespace pellucid::readers {
namespace {

TEST(UnitXmlTags, NamesAndAttributes) {
  const auto tags = xml_tags(std::string_view(
      "<?xml version=\"1.0\"?><!-- <No a=\"1\"/> --><A b = 'x > \"y\"' c=\"&lt;1 &amp; 2&gt;\">text"
      "</A><B/>"));
  ASSERT_EQ(tags.size(), 2u);
  EXPECT_EQ(tags[0].name, "A");
  EXPECT_EQ(tags[0].attributes.at("b"), "x > \"y\"");
  EXPECT_EQ(tags[0].attributes.at("c"), "<1 & 2>");
  EXPECT_EQ(tags[1].name, "B");
  EXPECT_TRUE(tags[1].attributes.empty());
}

TEST(PropertyXmlTags, AnyBytesEnd) {
  std::mt19937 random(1);
  const std::string_view letters = "<>/!-?\"'= ab&;";
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int k = 0; k < 60; ++k) text += letters[random() % letters.size()];
    for (const XmlTag& tag : xml_tags(std::string_view(text))) EXPECT_LE(tag.name.size(), 60u);
  }
}

}  // namespace
}  // namespace pellucid::readers
