// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/raster.h"

namespace pellucid::compare {

/// A Shift is in pixels, to the right and down.
struct Shift {
  double x = 0, y = 0;
  double uncertainty = 0;  // its standard deviation, of the larger one of both
};

/// Returns by how much the test is shifted against the reference, whose A tells what is covered,
/// within ±4 pixels: nothing where neither coverage nor values tell, or where undoing the shift
/// does not lessen the error of that by which it was found. Both pictures have one size and finite
/// values, and are over the background.
///
/// Coverage is asked first: of the reference A > 0, of the test what differs from the background by
/// more than its pixels far from anything covered do; what of the reference differs by hardly more
/// counts for neither. An edge that is sampled at half a pixel's distance moves by a whole pixel at
/// half of its pixels: so of n of them the mean is known to 0.5 / √n. Where too little is uncovered
/// to have edges of both directions, colours are asked instead.
std::optional<Shift> picture_shift(const Image& reference, const Image& test,
                                   const Vec3& background);

}  // namespace pellucid::compare
