// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <sstream>

#include "core/error.h"
#include "core/options/option_table.h"

namespace pellucid {

/// A value that the option takes and that is not its default: of its choices, of a few numbers, or
/// the given text.
inline std::string another_value(const ParameterSpec& spec, const std::string& text) {
  std::stringstream candidates{spec.choices.empty() ? "0.25|0.75|3|" + text
                                                    : std::string(spec.choices)};
  for (std::string candidate; std::getline(candidates, candidate, '|');) {
    if (candidate == spec.default_value) continue;
    try {
      Parameters("options", {&spec, 1}, {{std::string(spec.name), candidate}});
    } catch (const InputError&) {
      continue;
    }
    if (spec.kind != ParameterSpec::Kind::text || candidate == text) return candidate;
  }
  ADD_FAILURE() << spec.name << ": no other value than " << spec.default_value;
  return std::string(spec.default_value);
}

/// Expects that every option of the table changes the struct, whatever another one changed: two
/// that were bound to one member would change the same. `text` is for options of kind text.
template <class Options>
void expect_members_of_their_own(const OptionTable<Options>& table, const std::string& text = "") {
  const auto stored = [&](Options options, const Option<Options>& row) {
    row.store(options, another_value(row.spec, text));
    return options;
  };
  for (const Option<Options>& one : table.rows()) {
    const Options changed = stored(Options{}, one);
    EXPECT_FALSE(changed == Options{}) << one.spec.name;
    for (const Option<Options>& other : table.rows()) {
      if (&one == &other) continue;
      EXPECT_FALSE(stored(changed, other) == changed) << one.spec.name << ", " << other.spec.name;
      EXPECT_TRUE(stored(changed, other) == stored(stored(Options{}, other), one))
          << one.spec.name << ", " << other.spec.name;
    }
  }
}

}  // namespace pellucid
