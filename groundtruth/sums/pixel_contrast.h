// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/raster.h"

namespace pellucid::groundtruth {

/// Returns the indices into Image::pixels, ascending, of those that differ from one of their eight
/// neighbours by more than `contrast` in some channel and are not yet `marked`; marks them.
std::vector<std::size_t> mark_contrasts(const Image& image, double contrast,
                                        std::vector<bool>& marked);

}  // namespace pellucid::groundtruth
