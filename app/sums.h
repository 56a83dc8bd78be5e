// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/commands.h"
#include "compare/sums/sums_file.h"

namespace pellucid::app {

/// A SumsMerge says what is to be made of the sums of a scene's parts.
struct SumsMerge {
  std::vector<std::filesystem::path> files;
  std::string totals;   // of the first phase, where the files are of the second; else empty
  std::string picture;  // .exr or .png; empty: none
  std::string partial;  // the totals, .exr; empty: none
};

/// Prints what was summed up into `file`.
void print_sums(const std::string& file, const compare::SumsInfo& info,
                const GlobalOptions& globals);

/// Adds up sums of parts and composites them; where they are of the first of two phases, the second
/// is drawn in as many parts by the scene's file that they name. Throws as merge_sums(),
/// draw_second_phase() and composite_sums() do.
void merge_sums(const SumsMerge& request, const GlobalOptions& globals);

}  // namespace pellucid::app
