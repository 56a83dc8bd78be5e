// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// One picture of the deep pictures of a scene's parts.

#include <filesystem>
#include <functional>
#include <vector>

#include "compare/deep/deep_info.h"
#include "compare/deep/deep_row.h"
#include "core/progress.h"
#include "readers/pictures/deep_file.h"

namespace pellucid::compare {

/// DeepParts are the deep pictures of all parts of one scene, seen by one camera: every crossing of
/// a ray with the whole lies in one of them. They stay on disk, and are read some rows at a time.
class DeepParts {
 public:
  /// Reads what the pictures (.exr) say of themselves. Throws InputError that names the file which
  /// is damaged or no deep picture of ours, which differs from the first in scene, camera,
  /// resolution, background, program or number of parts, which is there twice, or which is missing.
  explicit DeepParts(const std::vector<std::filesystem::path>& files);

  /// Returns what the whole picture is of: part 1 of 1.
  const DeepInfo& whole() const { return whole_; }

  /// Returns where the rows end that are read together from row `first` on: as many as have
  /// `most_samples` in all parts together, and one at least.
  int end_of_rows(int first, std::uint64_t most_samples) const;

  /// Calls take(y, row) with every row of the whole picture, from the top: each pixel's layers of
  /// all parts, front to back, up to and with the first opaque one. No more rows are in memory than
  /// end_of_rows() says. Throws InputError where a file is damaged.
  void merge(const std::function<void(int y, const DeepRow& row)>& take, const Progress& progress,
             std::uint64_t most_samples = std::uint64_t(1) << 20) const;

 private:
  struct Part {
    std::filesystem::path file;
    readers::DeepHead head;
  };

  std::vector<DeepRow> merged_rows(int first, int end) const;

  std::vector<Part> parts_;
  DeepInfo whole_;
};

}  // namespace pellucid::compare
