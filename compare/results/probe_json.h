// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "scene/scene.h"

namespace pellucid::compare {

/// The exact crossings and sums along the rays through the centres of pixels, given as x, y, x, y,
/// …: {"depth": {near, far}, "pixels": [{x, y, color, transmittance, layers: […]}]}; a layer's keys
/// are those of RayLayer. An optical depth that is infinite is null. Throws InputError for a pixel
/// outside the picture.
nlohmann::json probe_json(const scene::Scene& scene, const std::vector<int>& pixels);

}  // namespace pellucid::compare
