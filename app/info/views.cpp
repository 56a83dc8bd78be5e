// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/info/views.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "compare/figure/sheet_drawing.h"
#include "compare/figure/sheet_files.h"
#include "compare/methods/methods.h"
#include "compare/views/contact_sheet.h"
#include "compare/views/rank_views.h"
#include "core/error.h"
#include "core/files/files_read.h"
#include "core/files/json_text.h"
#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"
#include "scene/halo.h"

namespace pellucid::app {
namespace {

using Json = nlohmann::ordered_json;

/// Pixels along the longer side: enough to count layers, and to look at.
constexpr int looked_through = 64, shown = 320;

Json to_json(const compare::RankedView& view) {
  const compare::ViewScore& score = view.score;
  return {{"camera", scene::camera_json(view.camera)},
          {"azimuth", view.azimuth},
          {"elevation", view.elevation},
          {"worth", view.worth},
          {"covered", score.covered},
          {"layers", score.layers},
          {"hidden", score.hidden},
          {"importance", score.importance}};
}

Json to_json(const scene::SceneCore& core, const std::vector<compare::RankedView>& views) {
  Json json{{"core",
             {{"center", {core.center.x, core.center.y, core.center.z}}, {"radius", core.radius}}},
            {"outliers", Json::array()},
            {"views", Json::array()}};
  for (const scene::SceneOutliers& o : core.outliers)
    json["outliers"].push_back(
        {{"object", o.object}, {"vertices", o.count}, {"distance", o.distance}});
  for (const compare::RankedView& view : views) json["views"].push_back(to_json(view));
  return json;
}

void print(const scene::SceneCore& core, const std::vector<compare::RankedView>& views) {
  for (const scene::SceneOutliers& o : core.outliers)
    fmt::print(
        "left out of the fit: {} vertices of {}, up to {:.4g} from the middle (radius {:.4g})\n",
        o.count, o.object, o.distance, core.radius);
  for (std::size_t i = 0; i < views.size(); ++i) {
    const compare::ViewScore& score = views[i].score;
    fmt::print(
        "{}: worth {:.2f}, covered {:.0f} %, {:.1f} visible layers, {:.0f} % hidden{}\n", i + 1,
        views[i].worth, 100 * score.covered, score.layers, 100 * score.hidden,
        score.importance > 0 ? fmt::format(", importance seen {:.3f}", score.importance) : "");
    fmt::print("   \"camera\": {}\n", json_text(scene::camera_json(views[i].camera)));
  }
}

std::vector<Image> draw(scene::Scene& scene, const std::vector<compare::RankedView>& views,
                        int width, int height, const Progress& progress) {
  const scene::MethodRow& row = compare::methods().front();  // the exact one
  scene.width = width;
  scene.height = height;
  std::vector<Image> pictures;
  for (const compare::RankedView& view : views) {
    report(progress, double(pictures.size()) / double(views.size()), "drawing the views");
    scene.camera = view.camera;
    scene::place_halos(scene);
    const Parameters defaults(row.name, row.parameters, {});
    pictures.push_back(row.make(scene, defaults, {})->render({}).image);
  }
  report(progress, 1, "drawn");
  return pictures;
}

}  // namespace

void tell_views(const std::filesystem::path& file, const ViewsOptions& options,
                const GlobalOptions& globals) {
  const ProtectedInputs protected_inputs;
  if (!options.output.empty()) compare::require_sheet_ending(options.output);
  const Progress progress = console_progress(globals);
  scene::Scene scene = scene::load_scene(file, progress);
  const double scale = double(shown) / std::max(scene.width, scene.height);
  const int width = std::max(1, int(scene.width * scale)),
            height = std::max(1, int(scene.height * scale));
  const scene::SceneCore core = scene::scene_core(scene);
  const std::vector<compare::RankedView> views =
      compare::rank_views(scene, core, options.count, looked_through, progress);
  if (views.empty())
    throw InputError(
        fmt::format("{}: nothing of the scene is seen from any side; accepted: objects "
                    "of some size and opacity",
                    file.string()));
  if (!options.output.empty()) {
    const compare::FigureStyle style;
    const std::vector<Image> pictures = draw(scene, views, width, height, progress);
    compare::write_sheet(options.output,
                         compare::contact_sheet(views, pictures, compare::text_ruler(style.font)),
                         style, "Views of " + scene.name);
  }
  if (globals.json)
    fmt::print("{}\n", json_text(to_json(core, views), 2));
  else
    print(core, views);
}

}  // namespace pellucid::app
