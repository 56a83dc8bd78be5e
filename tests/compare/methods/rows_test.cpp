// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <set>

#include "compare/methods/methods.h"

namespace pellucid::compare {
namespace {

TEST(PropertyMethodRows, ParametersAreNamedOnceAndTakeTheirDefaults) {
  for (const scene::MethodRow& row : methods()) {
    std::set<std::string_view> names;
    for (const ParameterSpec& spec : row.parameters) {
      SCOPED_TRACE(std::string(row.name) + ": " + std::string(spec.name));
      EXPECT_TRUE(names.insert(spec.name).second);
      EXPECT_FALSE(spec.help.empty());
      if (spec.default_value.empty()) continue;
      const std::string name(spec.name), value(spec.default_value);
      EXPECT_NO_THROW(Parameters(row.name, row.parameters, {{name, value}}));
    }
  }
}

TEST(PropertyMethodRows, TellWhatTheyWereCheckedAgainst) {
  for (const scene::MethodRow& row : methods())
    EXPECT_FALSE(row.checked_against.empty()) << row.name;
}

}  // namespace
}  // namespace pellucid::compare
