// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "groundtruth/methods/decoupled.h"
#include "groundtruth/methods/march.h"
#include "groundtruth/methods/raytrace.h"
#include "tests/support/options.h"

namespace pellucid::groundtruth {
namespace {

TEST(PropertyMethodOptions, EveryOptionHasAMemberOfItsOwn) {
  expect_members_of_their_own(raytrace_options());
  expect_members_of_their_own(march_options(), "dilate:0.5");
  expect_members_of_their_own(decoupled_options());
}

MarchMethodOptions read(const RawOptions& given) {
  return march_options().read(Parameters("march", march_options().specs(), given));
}

TEST(UnitMarchOptions, TheFilterIsReadOnce) {
  EXPECT_EQ(read({}).march.dilate, std::nullopt);
  EXPECT_EQ(read({{"filter", "none"}}).march.dilate, std::nullopt);
  EXPECT_EQ(read({{"filter", "dilate:0.5"}}).march.dilate, 0.5);
  for (const char* wrong : {"dilate:", "dilate:-1", "dilate:inf", "grow:1", ""})
    EXPECT_THROW(read({{"filter", wrong}}), InputError) << wrong;
}

TEST(UnitMarchOptions, StepsOfACellAreWhole) {
  EXPECT_EQ(read({{"step", "2"}}).march.steps_per_cell, 2);
  EXPECT_THROW(read({{"step", "2.5"}}), InputError);
}

}  // namespace
}  // namespace pellucid::groundtruth
