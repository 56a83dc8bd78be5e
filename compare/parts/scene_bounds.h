// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/progress.h"
#include "groundtruth/traversal/scene_part.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// SceneBounds are what a part of a scene has to know of the whole: with them a part reads the
/// objects alone of which it has a share, without them all of them, twice.
struct SceneBounds {
  std::string fingerprint;                   // see DeepInfo
  std::map<std::string, std::string> files;  // hash of the content of each that was read, by path
  std::string camera;                        // see scene::camera_text()
  int width = 0, height = 0;                 // pixels
  Box3 box;                                  // of all objects, world
  scene::DepthRange depths;                  // of all that is drawn
  double largest = 0;                        // as WholeScene has it
  std::vector<std::uint64_t> counts;         // shared_elements() of each object, opaque ones too

  bool operator==(const SceneBounds&) const = default;
};

/// Reads all of a scene's objects, one at a time, twice. Throws InputError for a scene with halos,
/// which lie around whole lines, and as load_scene() and PartCutter do.
SceneBounds measure_bounds(const std::filesystem::path& scene, const scene::ViewRequest& view,
                           const Progress& progress);

/// Writes them as JSON, every number so that it reads back as the same. Throws as OutputFile does.
void write_bounds(const std::filesystem::path& path, const SceneBounds& bounds);

/// Reads such a file. Throws InputError for any other one.
SceneBounds read_bounds(const std::filesystem::path& path);

/// Throws InputError, which names the scene, where a part that has read these files is not one of
/// the scene that was measured: a file has changed, or was not read then.
void check_unchanged(const SceneBounds& bounds, const std::set<std::filesystem::path>& files_read);

}  // namespace pellucid::compare
