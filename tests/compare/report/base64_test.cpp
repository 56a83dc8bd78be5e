// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/report/base64.h"

#include <gtest/gtest.h>

namespace pellucid::compare {
namespace {

TEST(UnitBase64, TheExamplesOfRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

TEST(UnitBase64, BytesAreUnsigned) {
  EXPECT_EQ(base64({"\xff\xef\xbe", 3}), "/+++");
  EXPECT_EQ(base64({"\0\0", 2}), "AAA=");
}

}  // namespace
}  // namespace pellucid::compare
