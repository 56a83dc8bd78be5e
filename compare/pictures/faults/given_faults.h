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

/// PairFaults are what looks wrong with one of two pictures of which neither is known to be right.
struct PairFaults {
  std::vector<std::string> of_reference, of_test;  // one of them is empty
  std::optional<std::string> straight;  // which has straight colours, where the other's are not
};

/// Says what a study would of TEST, by the background that REFERENCE's uncovered pixels show, and
/// with REFERENCE's faults in their place where those alone explain most of the error, or all of
/// it. Of two pictures that have opacities (`have_alpha`), equal ones, and no background, one may
/// have straight colours where the other's are multiplied by A: multiplied by A, too, they are less
/// than a third as far apart. That is told alone, where no fault explains more. Both have one size
/// and finite values.
PairFaults pair_faults(const Image& reference, const Image& test, bool have_alpha);

}  // namespace pellucid::compare
