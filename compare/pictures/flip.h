// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "compare/pictures/picture_text.h"
#include "core/raster.h"

namespace pellucid::compare {

/// Returns the map of LDR-FLIP, a value in [0, 1] per pixel: how large a difference is seen when
/// the two pictures alternate. Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild,
/// "FLIP: A Difference Evaluator for Alternating Images", PACMCGIT 3(2), 2020:
///
/// - red, green and blue are sRGB, clamped to [0, 1];
/// - the colour pipeline: the contrast sensitivity of the eye as Gaussians in YCxCz, clamped to the
///   display's colours, then HyAB of Hunt-adjusted L*a*b*, to the power of 0.7, mapped to [0, 1] so
///   that all below 0.4 of the largest takes 0.95 of the range;
/// - the feature pipeline: first and second derivatives of a Gaussian find edges and points in Y,
///   whose larger difference, to the power of a half, raises
/// - the difference of colours: ΔE = ΔE_c^(1 - ΔE_f).
///
/// The eye is 0.7 m from a display that is 0.7 m and 3840 pixels wide: 67.02 pixels per degree, the
/// paper's example. Pixels beyond the edge are as the nearest one. The paper's filters are cut off
/// where its authors' program cuts them off. They are applied as rows and columns; the sum of two
/// Gaussians as two such pairs. In float, as the published program: means agree to 1e-5 with
/// double.
///
/// Equal pictures give exactly 0, and the map is the same to the last bit for any number of
/// threads. Both pictures have one size and finite values.
Raster<float> flip_map(const Image& reference, const Image& test);

/// Returns the map in the colours of magma, from 0 to 1, as the paper shows it.
Image flip_picture(const Raster<float>& map);

/// Returns how that picture, or the map's own numbers as an .exr, is written.
PictureForm form_of_flip();

}  // namespace pellucid::compare
