// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vec.h"

namespace pellucid::scene {

/// Returns colour and opacity of the i-th sheet from the front of the data set `stack`: hues that
/// no two neighbours share.
Rgba stack_color(int i, double alpha);

}  // namespace pellucid::scene
