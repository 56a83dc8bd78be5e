// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/make_field.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace pellucid::fields {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

auto complaint(std::string_view text) {
  try {
    make_field(text);
  } catch (const InputError& error) {
    return std::string(error.what());
  }
  return std::string("no complaint");
}

TEST(UnitMakeField, OffersTheNearestNames) {
  EXPECT_THAT(complaint("abd"), HasSubstr("unknown field 'abd'; known: abc, "));
  EXPECT_THAT(complaint("abd"), HasSubstr("formula"));
  EXPECT_THAT(complaint("tornadoe:x=1"), HasSubstr("known: tornado, "));
}

TEST(UnitMakeField, ChecksKeysAndValues) {
  EXPECT_THAT(complaint("abc:D=1"), HasSubstr("field abc: unknown key 'D'; known: A, B, C, decay"));
  EXPECT_THAT(complaint("abc:A=one"), HasSubstr("field abc: A=one; accepted: any number"));
  EXPECT_THAT(complaint("abc:decay=-1"), HasSubstr("accepted: number ≥ 0"));
  EXPECT_THAT(complaint("tornado:r=1"), HasSubstr("it takes no parameters"));
  EXPECT_THAT(complaint(""), HasSubstr("the name is empty"));
}

TEST(UnitMakeField, DescriptionsHoldEveryParameter) {
  EXPECT_EQ(make_field("rotation:c=3")->description(), "rotation:c=3,omega=1");
  EXPECT_EQ(make_field("tornado")->description(), "tornado");
}

}  // namespace
}  // namespace pellucid::fields
