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
/// when the pixels that the reference leaves uncovered have another colour, or, where it leaves
/// none, when one colour behind all, by the reference's A, explains two thirds of the error; a
/// shift (picture_shift()) of a quarter of a pixel or more beyond three standard deviations. Both
/// pictures have one size and finite values.
std::vector<std::string> given_faults(const Image& reference, const Image& test,
                                      const Vec3& background);

/// Returns the median colour of the test where the reference has no layer; nothing where that is
/// too little to tell. Both have one size.
std::optional<Vec3> color_of_uncovered(const Image& reference, const Image& test);

/// Says which of two pictures looks to have straight colours where the other's are multiplied by A,
/// both without a background and of equal opacities: multiplied by A, they are less than a third as
/// far apart. Nothing where neither does. Both have one size and finite values.
std::optional<std::string> straight_colors(const Image& reference, const Image& test);

}  // namespace pellucid::compare
