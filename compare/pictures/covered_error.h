// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/raster.h"

namespace pellucid::compare {

/// A CoveredError is how far a picture is from the reference over the pixels with a layer there.
struct CoveredError {
  std::optional<double> rmse;  // over red, green and blue; nothing where no pixel is covered
  std::optional<double> ssim;  // mean of SSIM's map over those of them whose window lies inside
};

/// Compares two finite pictures of one size where `layers`, the reference's, are not 0.
CoveredError covered_error(const Image& reference, const CountImage& layers, const Image& test);

}  // namespace pellucid::compare
