// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/commands.h"

namespace pellucid::app {

/// CompareRunsOptions are what `compare` takes for two runs of a study.
struct CompareRunsOptions {
  std::filesystem::path output;  // folder for the page; empty: none
  bool ignore_times = false;     // they are told, but decide nothing
};

/// Adds --output and --ignore-times.
void add_run_options(CLI::App& command, CompareRunsOptions& options);

/// Prints what differs between two runs of a study. Throws WorkError where something does, and as
/// compare_runs() does.
void compare_run_folders(const std::filesystem::path& before, const std::filesystem::path& after,
                         const CompareRunsOptions& options, const GlobalOptions& globals);

}  // namespace pellucid::app
