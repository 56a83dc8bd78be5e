// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fields/sampled/dense_field.h"

namespace pellucid::fields {

/// Estimates the largest difference between the interpolant and the smooth field that was sampled,
/// in the samples' unit. `support` is the interpolation's: 1 (constant), 2 (linear) or 4 (c1).
/// Samples that are not finite, and axes too short for the differences, are passed over.
///
/// Of samples that hold in whole cells it is half the step between two cells, at their face, where
/// the field is straight; the axes' are summed, as at a cell's corner.
///
/// Along one axis of spacing h the largest error of straight lines is h²/8 |f''|. That of cubic
/// Hermite pieces with three-point slopes is, with s in [0, 1] the place in the cell,
///   h³ f''' s (1 - s)(1 - 2s)/6 + h⁴ f'''' s² (1 - s)²/24,
/// the first term from the slopes' own error -h²/6 f''', the second from the Hermite pieces: at
/// most √3/108 h³ |f'''| + h⁴/384 |f''''|. In the cells at the ends one slope is one-sided, its
/// error h²/3 f''', and the first term is h³ f''' s (1 - s)(2 - s)/6, at most √3/27 h³ |f'''|.
/// Derivatives are taken from differences of the samples; the axes' errors are summed.
template <class Sample>
double estimate_sampling_error(const DenseGrid<Sample>& grid, int support);

}  // namespace pellucid::fields
