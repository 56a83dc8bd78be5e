// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

namespace pellucid::app {

/// Adds --completion and --manual, which print and end the program. Added after all commands.
void add_manual_options(CLI::App& program);

}  // namespace pellucid::app
