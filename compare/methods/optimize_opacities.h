// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compare/methods/method_call.h"

namespace pellucid::compare {

/// Returns the names of the methods that optimize the opacities of vertices.
std::vector<std::string_view> opacity_methods();

/// Returns the call as it is. Throws InputError where its method does not optimize the opacities of
/// vertices, with the methods that do.
MethodCall checked_opacities(MethodCall call);

/// Returns the checked call that a command line writes as "NAME[:key=value,...]"; of an empty text
/// none. Throws InputError for an unknown name or parameter, and as checked_opacities() does.
std::optional<MethodCall> parse_opacities(const std::string& text);

/// Returns the samplings of pixels by which calls draw a scene beside its own: those of adaptive
/// ones, each once, the coarsest first.
std::vector<scene::PixelSampling> further_samplings(std::span<const MethodCall> calls);

/// Makes the opacities of least energy those of the scene, as `call`, a method that optimizes those
/// of vertices, finds them for the scene's camera and size: what any other method then composites
/// is the same. An element's opacity is the least that it has at any sample of a pixel, of the
/// scene's own samples and of those of `further`, by which it will be drawn, too: what none of them
/// sees is opaque, and is not drawn. Importance is gone from the scene after it.
///
/// This is opacity optimization as a stage of its own (Baeza Rojo et al. 2019, section 4.2, steps 1
/// to 3), before whichever compositing (step 5).
///
/// Throws InputError for a scene without importance and a call whose opacities are those of single
/// fragments; and what the method throws.
void optimize_opacities(const MethodCall& call, const scene::RenderContext& context,
                        scene::Scene& scene, std::span<const scene::PixelSampling> further = {});

}  // namespace pellucid::compare
