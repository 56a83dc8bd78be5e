// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "compare/methods/method_call.h"
#include "compare/pictures/picture_text.h"

namespace pellucid::app {

/// A DrawRequest says what is drawn, by what. All of it has to outlive the request.
struct DrawRequest {
  const compare::MethodCall& call;
  const std::optional<compare::MethodCall>& opacities;  // what chose those of the scene
  const scene::Scene& scene;
  bool explain = false;
};

/// A DrawnPicture is the picture by the method, and what it took.
// Moving nlohmann::json asserts, which the check takes for throwing.
// NOLINTNEXTLINE(bugprone-exception-escape)
struct DrawnPicture {
  scene::Rendering rendering;
  nlohmann::json json;                   // see compare::render_json()
  std::vector<std::string> explanation;  // where it is asked for
};

/// Draws it twice: the second picture is timed. Throws as the method does, and WorkError for a
/// picture that is not finite.
DrawnPicture draw_picture(const DrawRequest& request, const GlobalOptions& globals,
                          const Progress& progress);

/// Draws it by `raytrace`, whatever the call's method, and writes it as a TiledExr, of which a row
/// of tiles at a time is in the memory: the rendering has no picture. Throws likewise, and as
/// TiledExr does.
DrawnPicture draw_tiles(const DrawRequest& request, const std::string& path,
                        const compare::PictureForm& form, const Progress& progress);

}  // namespace pellucid::app
