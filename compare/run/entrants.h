// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Returns why a call does not compete on a scene, in words; nothing where it does: it draws only
/// what the reference draws, or it chooses opacities itself, so that its picture is meant to
/// differ.
std::optional<std::string> why_left_out(const MethodCall& call, const MethodCall& reference,
                                        const scene::Scene& scene);

/// Returns all methods of the table in all their settings whose name or call fits one of the shell
/// patterns, "fourier*,raytrace"; of an empty text all. Throws InputError where none does.
std::vector<MethodCall> calls_that_fit(std::string_view patterns,
                                       std::span<const scene::MethodRow> table);

}  // namespace pellucid::compare
