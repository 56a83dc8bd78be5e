// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/changes/changes.h"

namespace pellucid::compare {

/// Writes FOLDER/changes.html, one file with all in it, and FOLDER/changes.json: for each cell that
/// is not the same what differs, with both pictures and their error map side by side, the cells
/// whose pictures differ most first. Makes the folder. Throws InputError where it cannot.
void write_changes(const std::filesystem::path& folder, const RunChanges& changes,
                   const PastRun& before, const PastRun& after);

}  // namespace pellucid::compare
