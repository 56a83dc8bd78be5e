// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "compare/parts/scene_bounds.h"
#include "core/progress.h"
#include "groundtruth/traversal/scene_part.h"
#include "scene/files/view_request.h"

namespace pellucid::compare {

/// A MeasuredScene is a scene of several objects without their shapes.
struct MeasuredScene {
  scene::Scene scene;
  Box3 bounds;                        // of all objects, world
  std::vector<std::uint64_t> counts;  // shared_elements() of each, opaque ones too
  bool any_halo = false;
};

/// Reads a scene file, an object at a time. A single object keeps its shape. Throws as
/// load_scene().
MeasuredScene measure_scene(const std::filesystem::path& path, const Progress& progress,
                            const scene::ViewRequest& view);

/// Reads a scene file, and keeps a part of the scene's primitives. Where it has several objects
/// they are read twice, one at a time: first for the box of them all and the camera that sees them,
/// then to be cut; so that the largest object, and the part, have to find room in memory. A scene
/// with halos, which lie around whole lines, is read as a whole. With `known` bounds those objects
/// alone are read, once, of which the part has a share, and what is opaque where that stays whole.
/// Throws as load_scene() and take_part() do, and InputError for bounds of another view or number
/// of objects, and as check_unchanged().
groundtruth::ScenePart load_part(const std::filesystem::path& path, const Progress& progress,
                                 const scene::ViewRequest& view, const scene::PartNumber& part,
                                 scene::PartOf of = scene::PartOf::all_objects,
                                 const SceneBounds* known = nullptr);

}  // namespace pellucid::compare
