// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "fields/levels/level.h"
#include "fields/levels/value_gaps.h"

class vtkDataSet;

namespace pellucid::fields {

/// FileLevels are the levels of a scalar in a file.
struct FileLevels {
  std::vector<ScalarLevel> levels;
  Vec2 range{0};       // the least and the largest value: value_range() of a .vdb, else a sample's
  ValueGaps gaps;      // of a level set: value_gaps()
  std::string remark;  // which of several times was read unasked; empty without such
};

/// Reads the levels of a scalar from a file: the grids of a .vdb (read_vdb_levels()), or the one
/// grid of a file that VTK reads, at the time that readers::chosen_time() finds, the first if it is
/// empty: an image or a rectilinear grid of cubes along
/// the world's axes. A scalar of points, or of cells, whose centres are the samples then; or, where
/// none has the name and it is a derived one, that of the `velocity` (pick_vectors()). Throws
/// InputError, naming the file, for what is no such grid, with a way to make one, and for samples
/// that check_level() refuses; when there is no such array it lists those that there are.
FileLevels read_levels(const std::filesystem::path& path, std::string_view scalar,
                       const std::string& velocity = {}, const std::string& time = {});

/// Returns the level of a data set in the same way; `path` names its file in messages.
ScalarLevel level_of(vtkDataSet& data, const std::filesystem::path& path, std::string_view scalar,
                     const std::string& velocity = {});

}  // namespace pellucid::fields
