// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/progress.h"
#include "scene/files/object_file.h"
#include "scene/files/view_request.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// Reads a scene file ("pellucid-scene", version 1), its meshes, and integrates its surfaces.
/// Scene::name is the file's stem; `view` goes before what the file says of the view. Throws
/// InputError that names file, key and accepted values.
Scene load_scene(const std::filesystem::path& path, const Progress& progress = {},
                 const ViewRequest& view = {});

/// A SceneHead is what a scene file says beside its objects, which may take hours to read.
struct SceneHead {
  SceneView view;
  bool has_camera = false;          // else it is fitted to the objects
  std::vector<Camera> camera_path;  // as Scene has it
};

/// Reads a scene's head. Throws InputError as load_scene() does for what it reads.
SceneHead read_scene_head(const std::filesystem::path& path);

/// A TakeObject is given each object as soon as it has been read, lit, and seen by the camera that
/// is fitted to the scene, and the number of them all; it may cut the object down.
using TakeObject = std::function<void(SceneObject& object, std::size_t count)>;

/// A WantObject says of an object, by its index and whether it is opaque, whether it is to be read.
/// Of others nothing but their name, their light and whether they are opaque is known.
using WantObject = std::function<bool(std::size_t index, bool opaque)>;

/// Reads a scene as load_scene() does, for who need not have all of its objects in memory at once.
/// Halos are placed around what `take` has left of their lines. Without `want` all are read,
/// and with it no camera is fitted: where nobody has given one it is any.
Scene load_scene_by_objects(const std::filesystem::path& path, const Progress& progress,
                            const ViewRequest& view, const TakeObject& take,
                            const WantObject& want = {});

/// A SceneSource is where a scene's text comes from, if it is no file.
struct SceneSource {
  std::string file = "scene";      // stands for the file in messages
  std::filesystem::path folder{};  // where relative paths start; empty: the current folder
  GivenShapes given{};
};

/// Reads a scene from what a scene file would hold. Scene::name stays empty. Throws as
/// load_scene().
Scene read_scene(const nlohmann::json& text, const SceneSource& source,
                 const Progress& progress = {});

/// Reads one of a scene's objects, and appends it as load_scene() would have. Throws InputError,
/// and leaves the scene as it was.
void append_object(const nlohmann::json& object, const SceneSource& source, Scene& scene,
                   const Progress& progress = {});

/// Changes those of a scene's keys resolution, samples, camera, background, lighting and energy
/// that `text` has; halos follow the camera. `folder` is where relative paths start. Throws
/// InputError, and leaves the scene as it was.
void change_view(const nlohmann::json& text, const std::filesystem::path& folder, Scene& scene);

}  // namespace pellucid::scene
