// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "compare/sums/sums_file.h"
#include "core/progress.h"

namespace pellucid::compare {

/// A SumsAdder adds up the sums of a scene's parts, in double, one after the other: a float's
/// rounding of each would be seen after many.
class SumsAdder {
 public:
  /// Throws InputError that names `file` when its planes are not those of the first.
  void add(const std::filesystem::path& file, const SumsFile& sums);
  /// Returns the totals, as part 1 of 1.
  SumsFile total() const;

 private:
  struct Total {
    explicit Total(const scene::SumPlane& like);
    bool is_like(const scene::SumPlane& plane) const;
    void add(const scene::SumPlane& plane);
    scene::SumPlane plane() const;

    std::string name;
    scene::Combine combine;
    int channels;
    std::vector<double> values;
  };

  SumsInfo info_;
  Image behind_;
  std::vector<Total> totals_;
};

/// Returns what the sums of all parts of a scene add up to, in the order of the parts, however the
/// files are named; those of two files are in memory at once. Throws InputError that names the file
/// which is damaged or no sums, which differs from the first in picture, method, phase or planes,
/// which is there twice, or which is missing.
SumsFile merge_sums(const std::vector<std::filesystem::path>& files, const Progress& progress);

/// Throws InputError that names both files unless they are of one picture by one method; which
/// phase and which part they are may differ.
void check_same_sums(const std::filesystem::path& first_file, const SumsInfo& first,
                     const std::filesystem::path& file, const SumsInfo& other);

/// Throws InputError unless `totals`, of the file `totals_file`, are those of the first of two
/// phases over all parts, of the picture and method that `info`, of `file`, is of.
void check_totals(const std::filesystem::path& totals_file, const SumsInfo& totals,
                  const std::filesystem::path& file, const SumsInfo& info);

}  // namespace pellucid::compare
