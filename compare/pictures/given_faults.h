// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/raster.h"

namespace pellucid::compare {

/// Returns what looks wrong with a picture that another program made, each in words, beside what a
/// method's own error may be: rows or columns turned round, colours not over the background or over
/// another one, a transfer curve too many, pixels that are not sampled at their centres. Empty
/// where nothing does. Nothing is put right: errors are measured of the picture as it is.
///
/// A turn or a curve is named when undoing it leaves less than a third of the error; a background
/// when the pixels that the reference leaves uncovered have another colour; a shift when the edges
/// of what is covered lie a quarter of a pixel or more beside the reference's, all in one
/// direction. Both pictures have one size and finite values.
std::vector<std::string> given_faults(const Image& reference, const Image& test,
                                      const Vec3& background);

/// Says which of two pictures looks to have straight colours where the other's are multiplied by A,
/// both without a background and of equal opacities: multiplied by A, they are less than a third as
/// far apart. Nothing where neither does. Both have one size and finite values.
std::optional<std::string> straight_colors(const Image& reference, const Image& test);

/// A Shift is in pixels, to the right and down.
struct Shift {
  double x = 0, y = 0;
  double uncertainty = 0;  // its standard deviation, of either
};

/// Returns by how much what is covered, which differs from the background, is shifted against the
/// reference: the best whole pixels of ±2, then the rest from the gradients of both masks. An edge
/// that is sampled at half a pixel's distance moves by a whole pixel at half of its pixels: so of n
/// of them the mean is known to 0.5 / √n.
Shift coverage_shift(const Image& reference, const Image& test, const Vec3& background);

}  // namespace pellucid::compare
