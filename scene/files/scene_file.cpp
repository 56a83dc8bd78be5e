// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/files/json_node.h"
#include "core/options/names.h"
#include "scene/appearance/appearance.h"
#include "scene/files/camera_file.h"
#include "scene/files/object_file.h"
#include "scene/halo.h"
#include "scene/scene_fit.h"
#include "scene/view/camera_path.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

constexpr double any = std::numeric_limits<double>::max();
/// A picture of 2^28 pixels takes 4 GiB; anything larger is a slip of the hand.
constexpr int max_side = 1 << 14;

std::vector<Camera> read_camera_path(const JsonNode& node, const Camera& camera) {
  node.accept_keys({"frames", "orbit", "keys"});
  const int frames = node["frames"].integer(2, 100000);
  if (node.has("orbit") == node.has("keys")) node.fail("accepted: one of the keys orbit, keys");
  if (node.has("orbit")) return orbit(camera, node["orbit"].number(-any, any), frames);
  std::vector<Camera> keys;
  for (const JsonNode& key : node["keys"].elements()) keys.push_back(read_camera(key));
  std::vector<Camera> path = at_place(node, [&] { return between_keys(keys, frames); });
  at_place(node, [&] { std::ranges::for_each(path, camera_frame); });
  return path;
}

Lighting read_lighting(const JsonNode& node) {
  const std::string name = node.one_of({"none", "headlight", "phong"});
  return name == "none"        ? Lighting::none
         : name == "headlight" ? Lighting::headlight
                               : Lighting::phong;
}

EnergyWeights read_energy(const JsonNode& node) {
  node.accept_keys({"p", "q", "r", "lambda"});
  EnergyOptions given;
  for (const auto& [spec, texts, store] : energy_options().rows())
    if (node.has(spec.name)) store(given, number_text(node[spec.name].number(spec.min, spec.max)));
  return energy_weights(given, {});
}

struct Loader {
  fs::path folder;
  Progress progress;
  const ViewRequest& view;
  Scene scene;

  void take_size() {
    if (view.resolution) scene.width = (*view.resolution)[0];
    if (view.resolution) scene.height = (*view.resolution)[1];
    if (view.samples) scene.samples = *view.samples;
  }

  /// What is wrong with the call is told before anything is integrated. A fit needs to know the
  /// projection.
  void check_view() {
    if (!view.view.empty()) find_row("view", view.view, view_directions());
    if (view.camera.empty()) return;
    const Camera asked = camera_of_text(view.camera, scene.camera);
    scene.camera.projection = asked.projection;
    scene.camera.fov = asked.fov;
  }

  /// A camera that nobody has given sees all; what the call says goes before the file.
  void take_camera(bool is_in_file) {
    std::string& how = scene.provenance["camera"];
    how = "the scene file's";
    if (!view.view.empty() || !is_in_file) {
      const ViewDirection& from = view.view.empty()
                                      ? view_directions().front()
                                      : find_row("view", view.view, view_directions());
      scene.camera = fitted_camera(scene, from);
      how = fmt::format("fitted to the scene, {}", from.title);
    }
    if (view.camera.empty()) return;
    scene.camera = camera_of_text(view.camera, scene.camera);
    how += ", then --camera";
    check_camera("--camera");
  }

  void check_camera(const std::string& place) const {
    try {
      camera_frame(scene.camera);
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", place, error.what()));
    }
  }

  void read(const JsonNode& root) {
    root.accept_keys({"format", "version", "resolution", "samples", "camera", "camera_path",
                      "background", "lighting", "energy", "objects"});
    root["format"].one_of({"pellucid-scene"});
    root["version"].integer(1, 1);
    if (root.has("resolution")) {
      const auto sides = root["resolution"].elements();
      if (sides.size() != 2) root["resolution"].fail("accepted: two integers, width and height");
      scene.width = sides[0].integer(1, max_side);
      scene.height = sides[1].integer(1, max_side);
    }
    if (root.has("samples")) scene.samples = root["samples"].integer(1, 16);
    take_size();
    // A wrong camera is refused before anything is integrated.
    if (root.has("camera")) {
      scene.camera = read_camera(root["camera"]);
      at_place(root, [&] { return camera_frame(scene.camera); });
    }
    check_view();
    if (root.has("background")) {
      scene.background = root["background"].vec3();
      for (const JsonNode& channel : root["background"].elements()) channel.number(0, 1);
    }
    if (root.has("lighting")) scene.lighting = read_lighting(root["lighting"]);
    if (root.has("energy")) scene.energy = read_energy(root["energy"]);
    const auto objects = root["objects"].elements();
    if (objects.empty()) root["objects"].fail("the scene is empty; accepted: at least one object");
    for (std::size_t i = 0; i < objects.size(); ++i) {
      report(progress, double(i) / double(objects.size()), "loading " + objects[i].place());
      scene.objects.push_back(read_object(objects[i], {folder, progress, scene.provenance}));
      if (auto* mesh = std::get_if<geometry::TriangleMesh>(&scene.objects.back().shape);
          mesh && scene.lighting != Lighting::none)
        ensure_normals(*mesh);
    }
    take_camera(root.has("camera"));
    if (root.has("camera_path"))
      scene.camera_path = read_camera_path(root["camera_path"], scene.camera);
    place_halos(scene);
  }
};

}  // namespace

Scene load_scene(const fs::path& path, const Progress& progress, const ViewRequest& view) {
  const nlohmann::json json = read_json(path);
  Loader loader{path.parent_path(), progress, view, {}};
  loader.scene.name = path.stem().string();
  loader.read(JsonNode(path.string(), json));
  return std::move(loader.scene);
}

}  // namespace pellucid::scene
