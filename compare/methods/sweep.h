// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Returns every combination of `sets` with a value for `key`: a sweep's Cartesian product.
std::vector<RawOptions> crossed(const std::vector<RawOptions>& sets, const std::string& key,
                                const std::vector<std::string>& values);

/// Returns the method in all combinations of MethodRow::sweep. Throws InputError where its table
/// does not accept one.
std::vector<MethodCall> sweep_of(const scene::MethodRow& row);

/// Says whether the method draws nothing unless a call names a file.
bool needs_file(const scene::MethodRow& row);

/// Returns all methods in all their settings, in the table's order, but for those that optimize
/// opacity or need a file.
std::vector<MethodCall> every_method(std::span<const scene::MethodRow> table);

}  // namespace pellucid::compare
