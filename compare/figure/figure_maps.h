// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/figure/figure_content.h"

namespace pellucid::compare {

/// Returns the maps of the largest difference in red, green or blue from the reference, on the
/// ErrorScale. Of the reference's own row, `is_reference`, the map is empty. All pictures have one
/// size.
FigureMaps error_maps(const Image& reference, const std::vector<Image>& pictures,
                      const std::vector<bool>& is_reference);

/// Returns the maps of FLIP, from 0 to 1, likewise.
FigureMaps flip_maps(const Image& reference, const std::vector<Image>& pictures,
                     const std::vector<bool>& is_reference);

}  // namespace pellucid::compare
