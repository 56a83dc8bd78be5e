// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/commands.h"

namespace pellucid::app {

/// ViewsOptions are what `info` takes to find cameras.
struct ViewsOptions {
  int count = 0;  // of views; 0: none are asked for
  std::filesystem::path output;
};

/// Prints the views of a scene that are worth most, with their cameras as scene files have them,
/// and draws them on a contact sheet. Throws InputError for a scene of which nothing is seen.
void tell_views(const std::filesystem::path& scene, const ViewsOptions& options,
                const GlobalOptions& globals);

}  // namespace pellucid::app
