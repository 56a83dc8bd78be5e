// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What a scene file asks to be integrated: surfaces and lines of flows.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/files/json_node.h"
#include "core/progress.h"
#include "scene/scene.h"

namespace pellucid::scene {

/// A FlowSurface is a surface and what it was swept from, but for its appearance; a streak or time
/// surface was swept from nothing.
struct FlowSurface {
  geometry::TriangleMesh mesh;
  std::optional<FlowSource> source;
};

/// A FlowContext is what reading a flow's object needs beside its node: where relative paths start,
/// and the scalars that its appearance is by; what is integrated has "s", "t" and the like, others
/// are arrays of the field's files.
struct FlowContext {
  const std::filesystem::path& folder;
  std::vector<std::string> scalars;
  const Progress& progress;
};

/// Integrates the surface of an object's key "surface". `how` gets a line on it. Throws InputError
/// for a wrong key or value, a file that cannot be read or lacks a scalar, a surface without a
/// triangle, and one that a budget has cut short.
FlowSurface read_flow_surface(const JsonNode& node, const FlowContext& context, std::string& how);

/// Integrates the lines of an object's key "lines", where that is no file. `how` gets a line on
/// them. Throws InputError likewise.
geometry::LineSet read_flow_lines(const JsonNode& node, const FlowContext& context,
                                  std::string& how);

}  // namespace pellucid::scene
