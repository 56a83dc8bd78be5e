// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/options/option_table.h"

namespace pellucid::oit {

/// ListOptions are those of lists.
struct ListOptions {
  /// How many fragments are kept at once, at most; if it is not set, what the driver's largest
  /// texture buffer holds.
  std::optional<double> fragments_per_pass;

  bool operator==(const ListOptions&) const = default;
};
/// Returns the table of ListOptions.
const OptionTable<ListOptions>& list_options();

}  // namespace pellucid::oit
