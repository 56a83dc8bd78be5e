// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pellucid::app {

/// Returns the manual page of the program or of one of its commands, as man(1) reads it: what
/// --help says.
std::string manual_page(const CLI::App& app);

/// Returns the manual page of that name: "pellucid", or a command. Throws InputError for another.
std::string manual_page(const CLI::App& program, const std::string& name);

}  // namespace pellucid::app
