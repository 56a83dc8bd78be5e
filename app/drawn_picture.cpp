// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawn_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compare/pictures/picture_pair.h"
#include "compare/pictures/tiled_exr.h"
#include "compare/results/render_json.h"
#include "groundtruth/methods/raytrace.h"
#include "scene/files/camera_file.h"

namespace pellucid::app {
namespace {

/// How the scene was made, and what the method made of it.
std::vector<std::string> explanation(const scene::Scene& scene, const scene::Renderer& renderer) {
  std::vector<std::string> lines{fmt::format("camera: {} ({})", scene::camera_text(scene.camera),
                                             scene.provenance.at("camera"))};
  for (const auto& [object, how] : scene.provenance)
    if (object != "camera") lines.push_back(fmt::format("{}: {}", object, how));
  std::ranges::copy(renderer.explain(), std::back_inserter(lines));
  return lines;
}

void tell(const DrawRequest& request, scene::Renderer& renderer, DrawnPicture& drawn) {
  drawn.json = compare::render_json(request.call, request.opacities, request.scene,
                                    drawn.rendering.stats, renderer);
  if (!request.explain) return;
  drawn.explanation = explanation(request.scene, renderer);
  drawn.json["explanation"] = drawn.explanation;
}

}  // namespace

DrawnPicture draw_picture(const DrawRequest& request, const GlobalOptions& globals,
                          const Progress& progress) {
  const compare::MethodCall& call = request.call;
  const auto renderer = call.row->make(request.scene, call.parameters, {.gl = globals.gl});
  const std::string what = fmt::format("rendering {}", call.row->name);
  report(progress, 0.5, what);
  // A first frame compiles shaders and touches memory for the first time; the second is timed.
  renderer->render({.progress = part_of(progress, 0.5, 0.75, what)});
  DrawnPicture drawn;
  drawn.rendering =
      renderer->render({.layers = true, .progress = part_of(progress, 0.75, 1, what)});
  report(progress, 1, fmt::format("rendered {}", call.row->name));
  compare::require_finite(drawn.rendering.image, call.text());
  tell(request, *renderer, drawn);
  return drawn;
}

DrawnPicture draw_tiles(const DrawRequest& request, const std::string& path,
                        const compare::PictureForm& form, const Progress& progress) {
  const scene::Scene& scene = request.scene;
  const auto renderer = groundtruth::make_raytracer(
      scene, groundtruth::raytrace_options().read(request.call.parameters));
  compare::TiledExr file(path, scene.width, scene.height, form);
  DrawnPicture drawn;
  drawn.rendering.stats = renderer->render_rows(
      compare::TiledExr::side,
      [&](int, const Image& rows) {
        compare::require_finite(rows, request.call.text());
        file.add(rows);
      },
      part_of(progress, 0.5, 1, "rendering raytrace"));
  file.commit();
  tell(request, *renderer, drawn);
  return drawn;
}

}  // namespace pellucid::app
