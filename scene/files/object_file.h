// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <variant>

#include "core/files/json_node.h"
#include "core/progress.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// A GivenShape is geometry in memory; what its positions and indices claim has been checked.
using GivenShape = std::variant<geometry::TriangleMesh, geometry::LineSet, geometry::PointSet>;
/// GivenShapes stand for files: a scene's text names them where it may name a file.
using GivenShapes = std::map<std::string, std::shared_ptr<const GivenShape>, std::less<>>;

/// An ObjectContext is what all objects of a scene file share while they are read.
struct ObjectContext {
  std::filesystem::path folder;  // where relative paths start
  const Progress& progress;
  std::map<std::string, std::string>& provenance;  // gets a line on how the object was made
  const GivenShapes& given;
};

/// Reads or integrates one of a scene file's objects and applies its appearance. Throws InputError
/// that names file, key and accepted values.
SceneObject read_object(const JsonNode& node, const ObjectContext& context);

/// Returns what is known of an object before it is read: its name, its light and whether it is
/// opaque, of an empty mesh. Throws InputError for what is wrong with these.
SceneObject unread_object(const JsonNode& node);

/// Draws an object otherwise: applies those keys of `node` that say how it is drawn (color,
/// opacity, importance, opaque, lighting, radius, profile, halo, and the value of an isosurface),
/// and neither reads nor integrates anything that is there already. `object` was made by
/// read_object() of a node that differs in these keys' values alone, and had none of them that
/// `node` lacks; a colour by a scalar stays one by the same. Throws InputError as read_object()
/// does.
SceneObject restyled_object(const JsonNode& node, const ObjectContext& context, SceneObject object);

}  // namespace pellucid::scene
