// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/lists/layer_trees.h"
#include "oit/methods/tree/surface_strips.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// When the frames end: at the first of these.
struct TreeBudget {
  std::uint64_t lines = 15000;
  std::uint64_t lines_per_frame = 1000;
  std::optional<std::uint64_t> frames;  // not set: no limit
  std::optional<double> seconds;        // at the end of the frame that reaches them; likewise
  std::optional<double> change;         // root mean square over RGB between two frames' pictures

  bool operator==(const TreeBudget&) const = default;
};

/// TreeOptions are those of the method `tree`.
struct TreeOptions {
  TreeBudget budget;
  LayerRule rule;
  StripOptions strips;

  bool operator==(const TreeOptions&) const = default;
};
/// Returns the table of TreeOptions.
const OptionTable<TreeOptions>& tree_options();

/// The progressive per-pixel tree (Tian and Guenther, "Progressive Rendering of Transparent
/// Integral Surfaces", additional material, section 1, Algorithms 1 and 2). Lines of the surface
/// are integrated frame by frame, rasterized into lists, and merged into the layers of a tree that
/// every pixel keeps: a fragment within ε of a layer is averaged into it, another one becomes a
/// layer of its own. The layers are composited from front to back.
///
/// Depth is d, so that ε does not depend on the scene's unit. Beyond the paper: lines are strips in
/// the surface's tangent plane (surface_strips.h); the tree is balanced and linked from front to
/// back (layer_tree.glsl). Colours are averaged after lighting; the means of uv and normals are
/// left out, nothing here would read them. Objects without a FlowSource have no lines: their
/// triangles are inserted once, each fragment a layer that nothing is merged with.
///
/// Accuracy: exact for objects without a FlowSource; for the others no bound, see the study
/// tree-epsilon.
const scene::MethodRow& tree_method();

}  // namespace pellucid::oit
