// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster.h"

namespace pellucid::compare {

/// The window of scikit-image's SSIM, unless it is told otherwise, has so many pixels on a side.
constexpr int box_ssim_window = 7;

/// Returns what scikit-image's structural_similarity(x, y, data_range=1, channel_axis=-1) does:
/// SSIM with a window of 7×7 equal weights, sample covariance (over n - 1), K₁ = 0.01, K₂ = 0.03,
/// the mean over red, green and blue and over the pixels whose window lies inside. For tables of
/// others.
///
/// Both pictures have one size, at least 7×7, and finite values.
double box_ssim(const Image& x, const Image& y);

/// Returns the picture whose red, green and blue are all its luma in 8 bits as n/255: 0.299 R +
/// 0.587 G + 0.114 B of the 8-bit values, rounded to the nearest. SSIM of two such pictures is the
/// one of greyscale that many programs print.
Image luma8(const Image& image);

}  // namespace pellucid::compare
