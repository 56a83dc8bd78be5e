// SPDX-License-Identifier: GPL-3.0-or-later
// What a package says of itself.
#pragma once

#include "compare/pack/pack_run.h"

namespace pellucid::compare {

/// Returns run.sh, README.md, CITATION.cff, versions.json, manifest.sha256 (of `packed`) and
/// ro-crate-metadata.json (RO-Crate 1.1: the study's run as a CreateAction).
std::vector<PackedFile> pack_texts(const PastRun& run, const Study& study, const PackedRun& packed);

}  // namespace pellucid::compare
