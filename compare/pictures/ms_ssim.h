// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/pictures/ssim.h"

namespace pellucid::compare {

/// Pictures with a side below this many pixels have no MS-SSIM: the coarsest of five scales would
/// have no whole window.
constexpr int ms_ssim_side = 16 * ssim_window;

/// Returns the multi-scale structural similarity: Wang, Simoncelli, Bovik, "Multi-Scale Structural
/// Similarity for Image Quality Assessment", Asilomar 2003, Eq. 7 with the
/// weights that its experiment found. Each scale's factor is its mean over the pixels (contrast and
/// structure, at the coarsest scale luminance too), by channel; the result is the mean over red,
/// green and blue. From scale to scale 2×2 pixels become their mean; an odd last row or column is
/// its own mirror image. A mean below 0, of pictures that are each other's negative, counts as 0,
/// since its power is not real.
///
/// `finest` is ssim_scores(x, y). Both pictures have one size, at least 176×176, and finite values.
double mean_ms_ssim(const Image& x, const Image& y, const SsimScores& finest);

}  // namespace pellucid::compare
