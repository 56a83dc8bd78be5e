// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pellucid::app {

/// Returns what a shell, "bash" or "zsh", reads to complete commands, options and names of tables.
/// Throws InputError for another shell.
std::string completion(const CLI::App& program, const std::string& shell);

}  // namespace pellucid::app
