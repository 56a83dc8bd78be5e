// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fields/levels/exact_levels.h"
#include "fields/levels/value_gaps.h"

namespace pellucid::fields {

/// FileLevels are the levels of a scalar in a file, or in several.
struct FileLevels {
  ExactLevels levels;
  Vec2 range{0};   // the least and the largest value: value_range() of a .vdb, else a sample's
  ValueGaps gaps;  // of a level set: value_gaps()
  std::vector<std::string> remarks;  // what was chosen unasked: of several times or arrays
};

/// Appends the levels of a further file.
void append(FileLevels more, FileLevels& files);

/// Reads the levels of a scalar from a file: the grids of a .vdb (levels_of()), the one grid of a
/// file that VTK reads or of a MetaImage (level_of()), or those of the files that a .pvd or a
/// .series lists at one time. The time is the one that readers::chosen_time() finds, the first if
/// `time` is empty. Throws InputError, naming the file, for one of another ending, with those that
/// are accepted, and for what its reader refuses.
FileLevels read_levels(const std::filesystem::path& path, std::string_view scalar,
                       const std::string& velocity = {}, const std::string& time = {});

}  // namespace pellucid::fields
