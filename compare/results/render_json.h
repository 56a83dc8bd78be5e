// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Returns what a picture took, as `render --stats` writes it: the call, seconds by step, bytes by
/// what they are for, counts, measures, the machine, and from where the scene was seen. `renderer`
/// made the picture of the scene.
nlohmann::json render_json(const MethodCall& call, const std::optional<MethodCall>& opacities,
                           const scene::Scene& scene, const scene::RenderStats& stats,
                           scene::Renderer& renderer);

}  // namespace pellucid::compare
