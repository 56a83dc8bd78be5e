// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/scenes/viewed_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/files/json_text.h"
#include "scene/files/camera_file.h"
#include "scene/files/scene_file.h"
#include "scene/halo.h"
#include "scene/view/camera_fit.h"
#include "view/scenes/object_controls.h"

namespace pellucid::view {
namespace {

bool any_setting(const std::vector<RawOptions>& objects) {
  return std::ranges::any_of(objects, [](const RawOptions& settings) { return !settings.empty(); });
}

/// The objects that the file names: halos are made for a camera.
std::vector<const scene::SceneObject*> named_objects(const scene::Scene& scene) {
  std::vector<const scene::SceneObject*> objects;
  for (const scene::SceneObject& object : scene.objects)
    if (!object.is_halo) objects.push_back(&object);
  return objects;
}

}  // namespace

ViewedScene::ViewedScene(std::filesystem::path file, const Progress& progress)
    : file_(std::move(file)),
      text_(read_json(file_)),
      loaded_(scene::load_scene(file_, progress)) {}

nlohmann::ordered_json ViewedScene::description() const {
  nlohmann::ordered_json objects = nlohmann::ordered_json::array();
  const auto made = named_objects(loaded_);
  for (std::size_t i = 0; i < made.size(); ++i)
    objects.push_back(
        {{"name", made[i]->name}, {"controls", control_rows(text_["objects"][i], *made[i])}});
  nlohmann::ordered_json views = nlohmann::ordered_json::array();
  for (const scene::ViewDirection& view : scene::view_directions())
    views.push_back({{"name", view.name}, {"title", view.title}});
  return {{"name", loaded_.name},
          {"holds", scene::describe_primitives(loaded_)},
          {"size", {loaded_.width, loaded_.height}},
          {"camera", scene::camera_json(loaded_.camera)},
          {"samples", scene::samples_json(loaded_.samples)},
          {"importance", scene::has_importance(loaded_)},
          {"objects", objects},
          {"views", views}};
}

scene::Scene ViewedScene::restyled(const std::vector<RawOptions>& objects) const {
  const auto made = named_objects(loaded_);
  if (objects.size() != made.size())
    throw InputError(fmt::format("objects: {}; accepted: {}, as many as the scene's, or none",
                                 objects.size(), made.size()));
  scene::Scene scene = loaded_;
  std::erase_if(scene.objects, [](const scene::SceneObject& object) { return object.is_halo; });
  for (std::size_t i = 0; i < objects.size(); ++i) {
    if (objects[i].empty()) continue;
    const nlohmann::json text = with_settings(text_["objects"][i], *made[i], objects[i]);
    const JsonNode node(fmt::format("{}: objects[{}]", file_.string(), i), text);
    const scene::GivenShapes none;
    const Progress quiet;
    scene::SceneObject object = scene::restyled_object(
        node, {file_.parent_path(), quiet, scene.provenance, none}, std::move(scene.objects[i]));
    object.name = made[i]->name;
    scene.objects[i] = std::move(object);
  }
  return scene;
}

scene::Scene& ViewedScene::styled(const std::vector<RawOptions>& objects) {
  if (!any_setting(objects)) {
    restyled_.reset();
    settings_.clear();
    return loaded_;
  }
  if (!restyled_ || settings_ != objects) {
    restyled_ = restyled(objects);
    settings_ = objects;
  }
  return *restyled_;
}

const scene::Scene& ViewedScene::look(const ViewState& state) {
  scene::Scene& scene = styled(state.objects);
  scene.camera = state.camera;
  scene.width = state.width;
  scene.height = state.height;
  scene.samples = {.per_axis = state.samples};
  scene::place_halos(scene);
  return scene;
}

}  // namespace pellucid::view
