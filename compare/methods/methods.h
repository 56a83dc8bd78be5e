// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string_view>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Returns ground truth and every order-independent method: the one table that the command line,
/// study files, property tests, benchmarks, report and README iterate. The reference comes first.
std::span<const scene::MethodRow> methods();

/// Returns methods() and `glsl`, which is whatever its file says: all that a call can name.
std::span<const scene::MethodRow> callable_methods();

/// Reads a call of one of the rows: "fourier:bands=5". Throws InputError that says what is
/// accepted.
MethodCall parse_call(std::string_view text,
                      std::span<const scene::MethodRow> rows = callable_methods());

}  // namespace pellucid::compare
