// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>

#include "core/options/parameters.h"

namespace pellucid {

/// Returns a table of parameters for a page that makes controls of it: an array of {"name", "kind",
/// "default", "accepted", "unit", "help"}, and where they are known "min" and "max", the bounds of
/// a number in its unit, and "choices", names.
nlohmann::ordered_json parameters_json(std::span<const ParameterSpec> parameters);

}  // namespace pellucid
