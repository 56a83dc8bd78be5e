// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace pellucid::scene {

/// Bounds of a key whose number may be any finite one: -any to any.
inline constexpr double any = std::numeric_limits<double>::max();

}  // namespace pellucid::scene
