// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/raster.h"

namespace pellucid::compare {

/// The window of SSIM has so many pixels on a side.
constexpr int ssim_window = 11;
/// C₁ is (K₁ L)² of Wang et al. 2004, for values from 0 to L = 1.
constexpr double ssim_c1 = 0.01 * 0.01;
/// C₂ is (K₂ L)².
constexpr double ssim_c2 = 0.03 * 0.03;
/// So many pixels from each edge of a picture have no window that lies inside.
constexpr int ssim_margin = ssim_window / 2;

/// ChannelValues are a number each of red, green and blue.
using ChannelValues = std::array<double, 3>;

/// The SsimScores of two pictures are how alike they are around each pixel whose window lies
/// inside.
struct SsimScores {
  Raster<double> map;        // mean over red, green and blue; lacks ssim_margin pixels on each side
  ChannelValues similarity;  // mean over the pixels
  ChannelValues
      contrast;  // the same of the factor of contrast and structure alone (2σ_xy + C₂) / …
};

/// Returns the structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment:
/// From Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004, Eqs. 13-17 with a
/// Gaussian window of 11×11 and σ = 1.5, K₁ = 0.01, K₂ = 0.03, L = 1. It is scikit-image's
/// structural_similarity with gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
/// data_range=1. Equal pictures give exactly 1. It is the same to the last bit for any number of
/// threads.
///
/// Both pictures have one size, at least 11×11, and finite values.
SsimScores ssim_scores(const Image& x, const Image& y);

}  // namespace pellucid::compare
