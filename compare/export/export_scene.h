// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "core/progress.h"
#include "scene/renderer.h"

namespace pellucid::compare {

/// An ExportRequest says what is left in an exported scene's folder beside scene.json and the
/// objects.
struct ExportRequest {
  bool gltf = true;       // scene.glb, where it is below glTF's 4 GiB
  bool reference = true;  // reference.exr, the exact picture
  Progress progress = {};
};

/// The name of the file that describes an exported scene, in its folder.
inline constexpr const char* exported_scene_name = "scene.json";

/// Leaves in the folder, which has to exist, what is drawn, for other renderers: scene.json, one
/// binary PLY file per object, and what is asked for. Positions are rounded to floats; scene.json
/// says by how much. Throws InputError for an isosurface that is no mesh, and as write_text() does.
void export_scene(const scene::Scene& scene, const std::filesystem::path& folder,
                  const ExportRequest& request);

/// Writes the camera as scene.json has it. Throws as write_text() does.
void export_camera(const scene::Scene& scene, const std::filesystem::path& file);

}  // namespace pellucid::compare
