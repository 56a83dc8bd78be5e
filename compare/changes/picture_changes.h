// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/changes/changes.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Returns where two pictures of one size differ; nothing where they are the same to the last bit.
std::optional<PictureChange> picture_change(const Image& before, const Image& after);

/// Returns what differs between a cell's pictures in two runs' folders, from each view.
std::vector<PictureChange> picture_changes(const PastRun& before, const PastRun& after,
                                           const ResultRow& of_before, const ResultRow& of_after);

}  // namespace pellucid::compare
