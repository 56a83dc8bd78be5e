// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/changes/past_run.h"
#include "compare/pack/archive.h"
#include "compare/study/study.h"

namespace pellucid::compare {

/// A PackedRun is all that somebody else needs to run a study again.
struct PackedRun {
  std::string study;  // the study's file within the package
  std::vector<PackedFile> files;
};

/// Lists the files of a package: the study and all that its cells have read, below inputs/ in the
/// folders in which they lie towards each other; what the run has left, below results/; and what
/// pack_texts() writes. Throws InputError, one line, for an input that is missing, has other
/// content than it had, or is named by an absolute path; for a study whose cells are not those of
/// the run; and for programs and pictures from elsewhere, which cannot be run again.
PackedRun pack_run(const PastRun& run, const Study& study);

/// Returns the file of the study that a run's results name. Throws InputError where they name none.
std::filesystem::path study_of_run(const std::filesystem::path& folder);

}  // namespace pellucid::compare
