// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/raster.h"

namespace pellucid::compare {

/// The window of SSIM has so many pixels on a side.
constexpr int ssim_window = 11;

/// Returns the mean structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality
/// Assessment: From Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004, Eqs. 13-17
/// with a Gaussian window of 11×11 and σ = 1.5, K₁ = 0.01, K₂ = 0.03, L = 1. It is scikit-image's
/// structural_similarity with gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
/// data_range=1: the mean over red, green and blue, and over the pixels whose window lies inside.
/// Equal pictures give exactly 1. It is the same to the last bit for any number of threads.
///
/// Both pictures have one size, at least 11×11, and finite values.
double mean_ssim(const Image& x, const Image& y);

}  // namespace pellucid::compare
