// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/scene_file.h"

#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/files/json_node.h"
#include "scene/appearance/appearance.h"
#include "scene/files/camera_file.h"
#include "scene/files/object_file.h"
#include "scene/halo.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

/// A picture of 2^28 pixels takes 4 GiB; anything larger is a slip of the hand.
constexpr int max_side = 1 << 14;

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
  Scene scene;

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
    // A wrong camera is refused before anything is integrated.
    if (root.has("camera")) {
      scene.camera = read_camera(root["camera"]);
      at_place(root, [&] { return camera_frame(scene.camera); });
    }
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
    if (!root.has("camera")) scene.camera = fitted_camera(scene.bounds());
    if (root.has("camera_path"))
      scene.camera_path = read_camera_path(root["camera_path"], scene.camera);
    place_halos(scene);
  }
};

}  // namespace

Scene load_scene(const fs::path& path, const Progress& progress) {
  const nlohmann::json json = read_json(path);
  Loader loader{path.parent_path(), progress, {}};
  loader.scene.name = path.stem().string();
  loader.read(JsonNode(path.string(), json));
  return std::move(loader.scene);
}

}  // namespace pellucid::scene
