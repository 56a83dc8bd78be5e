// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/options/parameters.h"
#include "scene/scene.h"

namespace pellucid::view {

/// Returns the controls of how an object is drawn, rows as parameters_json() has them, whose
/// defaults are what its scene file says: opacity, colour map, isovalue, radius or its scale, halo,
/// of these what `object`, its text in the scene file, has. `made` is what was read of it.
nlohmann::ordered_json control_rows(const nlohmann::json& object, const scene::SceneObject& made);

/// Returns the object's text with the controls at the values of `settings`. Throws InputError for a
/// control that the object does not have, and a value out of its bounds.
nlohmann::json with_settings(nlohmann::json object, const scene::SceneObject& made,
                             const RawOptions& settings);

}  // namespace pellucid::view
