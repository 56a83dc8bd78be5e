// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/files/scene_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "core/files/json_node.h"
#include "core/options/names.h"
#include "scene/appearance/appearance.h"
#include "scene/files/appearance_file.h"
#include "scene/files/camera_file.h"
#include "scene/files/object_file.h"
#include "scene/halo.h"
#include "scene/scene_fit.h"

namespace pellucid::scene {
namespace {

namespace fs = std::filesystem;

/// A picture of 2^28 pixels takes 4 GiB; anything larger is a slip of the hand.
constexpr int max_side = 1 << 14;

/// n, or {"frames": n}.
PixelSampling read_samples(const JsonNode& node) {
  if (!node.value().is_object()) return {.per_axis = node.integer(1, 16)};
  node.accept_keys({"frames"});
  return {.frames = node["frames"].integer(1, 4096)};
}

EnergyWeights read_energy(const JsonNode& node) {
  node.accept_keys({"p", "q", "r", "lambda"});
  EnergyOptions given;
  for (const auto& [spec, texts, store] : energy_options().rows())
    if (node.has(spec.name)) store(given, number_text(node[spec.name].number(spec.min, spec.max)));
  return energy_weights(given, {});
}

/// The keys of a scene that do not say what it holds.
constexpr std::array<std::string_view, 6> view_keys{"resolution", "samples",  "camera",
                                                    "background", "lighting", "energy"};

void read_resolution(const JsonNode& node, SceneView& scene) {
  const auto sides = node.elements();
  if (sides.size() != 2) node.fail("accepted: two integers, width and height");
  scene.width = sides[0].integer(1, max_side);
  scene.height = sides[1].integer(1, max_side);
}

void read_view(const JsonNode& root, const fs::path& folder, SceneView& scene) {
  if (root.has("resolution")) read_resolution(root["resolution"], scene);
  if (root.has("samples")) scene.samples = read_samples(root["samples"]);
  if (root.has("camera")) {
    scene.camera = read_camera(root["camera"], folder);
    at_place(root, [&] { return camera_frame(scene.camera); });
  }
  if (root.has("background")) scene.background = read_rgb(root["background"]);
  if (root.has("lighting")) scene.lighting = read_lighting(root["lighting"]);
  if (root.has("energy")) scene.energy = read_energy(root["energy"]);
}

void light(SceneObject& object, const SceneView& view) {
  auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape);
  if (mesh && lighting_of(view, object) != Lighting::none) ensure_normals(*mesh);
}

struct Loader {
  const SceneSource& source;
  const Progress& progress;
  const ViewRequest& view;
  const TakeObject& take;
  const WantObject& want;
  Scene scene;
  std::optional<CameraFit> fit = std::nullopt;  // of a camera that nobody has given

  void take_size() {
    if (view.resolution) scene.width = (*view.resolution)[0];
    if (view.resolution) scene.height = (*view.resolution)[1];
    if (view.samples) scene.samples = {.per_axis = *view.samples};
    if (view.background) scene.background = *view.background;
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

  /// Keys say where the camera is; what is asked of it beside that holds for each of them.
  void check_path(const JsonNode& root) const {
    if (!view.along_path || !root.has("camera_path") || !root["camera_path"].has("keys")) return;
    const bool is_eye = sets_eye(view.camera);
    if (is_eye || !view.view.empty())
      throw InputError(fmt::format(
          "{}: the keys of {}'s camera_path say where the camera is; accepted: --camera with "
          "target, up, fov or height, which hold for each key, or --orbit in the place of the path",
          is_eye ? "--camera eye" : "--view", source.file));
  }

  const ViewDirection& direction() const {
    return view.view.empty() ? view_directions().front()
                             : find_row("view", view.view, view_directions());
  }

  /// A camera that nobody has given sees all; what the call says goes before the file.
  void take_camera() {
    std::string& how = scene.provenance["camera"];
    how = "the scene file's";
    if (fit) {
      scene.camera = fit->camera();
      how = fmt::format("fitted to the scene, {}", direction().title);
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
    std::vector<std::string_view> keys{"format", "version", "camera_path", "objects"};
    keys.insert(keys.end(), view_keys.begin(), view_keys.end());
    root["format"].one_of({"pellucid-scene"});  // of another kind of file all keys are unknown
    root.accept_keys(keys);
    root["version"].integer(1, 1);
    read_view(root, source.folder,
              scene);  // a wrong camera is refused before anything is integrated
    take_size();
    check_view();
    check_path(root);
    const auto objects = root["objects"].elements();
    if (objects.empty()) root["objects"].fail("the scene is empty; accepted: at least one object");
    if (!want && (!view.view.empty() || !root.has("camera")))
      fit.emplace(scene.camera.projection, scene.camera.fov, direction(),
                  double(scene.width) / double(scene.height));
    for (std::size_t i = 0; i < objects.size(); ++i) {
      report(progress, double(i) / double(objects.size()), "loading " + objects[i].place());
      add(objects[i], i);
      if (fit) show(scene.objects.back(), *fit);
      if (take) take(scene.objects.back(), objects.size());
    }
    take_camera();
    if (root.has("camera_path"))
      scene.camera_path = read_camera_path(root["camera_path"], source.folder, scene.camera,
                                           view.along_path ? view.camera : std::string());
    place_halos(scene);
  }

  void add(const JsonNode& node, std::size_t index) {
    SceneObject unread = unread_object(node);
    if (want && !want(index, unread.opaque)) {
      scene.objects.push_back(std::move(unread));
      return;
    }
    scene.objects.push_back(
        read_object(node, {source.folder, progress, scene.provenance, source.given}));
    light(scene.objects.back(), scene);
  }
};

}  // namespace

Scene load_scene(const fs::path& path, const Progress& progress, const ViewRequest& view) {
  return load_scene_by_objects(path, progress, view, {});
}

Scene load_scene_by_objects(const fs::path& path, const Progress& progress, const ViewRequest& view,
                            const TakeObject& take, const WantObject& want) {
  const nlohmann::json json = read_json(path);
  const SceneSource source{path.string(), path.parent_path()};
  Loader loader{source, progress, view, take, want, {}};
  loader.scene.name = path.stem().string();
  loader.scene.file = path.string();
  loader.read(JsonNode(source.file, json));
  return std::move(loader.scene);
}

SceneHead read_scene_head(const fs::path& path) {
  const nlohmann::json json = read_json(path);
  const JsonNode root(path.string(), json);
  SceneHead head;
  read_view(root, path.parent_path(), head.view);
  head.has_camera = root.has("camera");
  if (root.has("camera_path"))
    head.camera_path =
        read_camera_path(root["camera_path"], path.parent_path(), head.view.camera, "");
  return head;
}

Scene read_scene(const nlohmann::json& text, const SceneSource& source, const Progress& progress) {
  const ViewRequest as_given;
  const TakeObject keep_all;
  const WantObject want_all;
  Loader loader{source, progress, as_given, keep_all, want_all, {}};
  loader.read(JsonNode(source.file, text));
  return std::move(loader.scene);
}

void append_object(const nlohmann::json& object, const SceneSource& source, Scene& scene,
                   const Progress& progress) {
  const auto count = std::ranges::count(scene.objects, false, &SceneObject::is_halo);
  const std::string place = fmt::format("objects[{}]", count);
  std::map<std::string, std::string> provenance;
  SceneObject made = read_object(JsonNode(source.file + ": " + place, object),
                                 {source.folder, progress, provenance, source.given});
  if (made.name.empty()) made.name = place;
  light(made, scene);
  scene.objects.push_back(std::move(made));
  place_halos(scene);
  for (auto& [where, how] : provenance) scene.provenance[place + where] = std::move(how);
}

void change_view(const nlohmann::json& text, const fs::path& folder, Scene& scene) {
  const JsonNode root("scene", text);
  root.accept_keys(view_keys);
  SceneView view = scene;
  read_view(root, folder, view);
  static_cast<SceneView&>(scene) = view;
  if (root.has("camera")) scene.provenance["camera"] = "given";
  for (SceneObject& object : scene.objects) light(object, scene);
  place_halos(scene);
}

}  // namespace pellucid::scene
