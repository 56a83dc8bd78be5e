// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/renderer.h"

namespace pellucid::oit {

/// Weighted average (Bavoil and Myers 2008, "Order independent transparency with dual depth
/// peeling", NVIDIA): every layer of a pixel has the mean opacity and the mean colour.
///
///   C = (sum alpha_i C_i / sum alpha_i) (1 - (1 - a)^n) + C_bg (1 - a)^n,  a = sum alpha_i / n
///
/// Accuracy: exact for one layer and for layers that are all alike; no bound otherwise.
const scene::MethodRow& weighted_average_method();

}  // namespace pellucid::oit
