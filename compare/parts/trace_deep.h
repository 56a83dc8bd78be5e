// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "compare/deep/deep_row.h"
#include "core/progress.h"

namespace pellucid::compare {

/// Finds every crossing of the ray through each pixel's centre and calls take(y, row) with every
/// row, from the top. No more than one row is in memory.
void trace_deep(const scene::Scene& scene, const groundtruth::RayProbe& probe,
                const std::function<void(int y, const DeepRow& row)>& take,
                const Progress& progress);

}  // namespace pellucid::compare
