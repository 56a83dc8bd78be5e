// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace pellucid::compare {

// The transfer curve of sRGB (IEC 61966-2-1), of values in [0, 1]; T is float or double.

/// Returns what a linear value is encoded as.
template <class T>
T encoded_as_srgb(T linear) {
  return linear <= T(0.0031308) ? T(12.92) * linear
                                : T(1.055) * std::pow(linear, T(1 / 2.4)) - T(0.055);
}

/// Returns the linear value that is encoded so.
template <class T>
T decoded_from_srgb(T encoded) {
  return encoded <= T(0.04045) ? encoded / T(12.92)
                               : std::pow((encoded + T(0.055)) / T(1.055), T(2.4));
}

}  // namespace pellucid::compare
