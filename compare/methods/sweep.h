// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Every combination of `sets` with a value for `key`: a sweep's Cartesian product.
std::vector<RawOptions> crossed(const std::vector<RawOptions>& sets, const std::string& key,
                                const std::vector<std::string>& values);

/// The method in all combinations of MethodRow::sweep.
std::vector<MethodCall> sweep_of(const scene::MethodRow& row);

/// All methods in all their settings, in the table's order, but for those that optimize opacity.
std::vector<MethodCall> every_method(std::span<const scene::MethodRow> table);

}  // namespace pellucid::compare
