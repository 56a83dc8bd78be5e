// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace pellucid::compare {

/// Returns a number as JSON has it: what is not known, and NaN, is null. JSON has no infinity: one
/// is the text "inf" or "-inf", as results.csv prints it.
nlohmann::json number_json(std::optional<double> value);

/// Returns what such a value says. Throws nlohmann's exceptions for any other.
std::optional<double> number_of(const nlohmann::json& json);

}  // namespace pellucid::compare
