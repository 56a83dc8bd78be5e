// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "oit/lists/layer_trees.h"
#include "oit/methods/tree/line_sources.h"
#include "scene/renderer.h"

namespace pellucid::oit {

/// When the frames end: at the first of these.
struct TreeBudget {
  std::uint64_t lines = 15000;  // of all integrated surfaces together
  std::uint64_t lines_per_frame = 1000;
  std::optional<std::uint64_t> frames;  // not set: no limit
  std::optional<double> seconds;        // at the end of the frame that reaches them; likewise
  std::optional<double> change;         // root mean square over RGB between two frames' pictures

  bool operator==(const TreeBudget&) const = default;
};

/// SampledObjects are those whose fragments are samples of a surface, so that those within ε of
/// each other are one layer. The others' are crossings, each a layer by itself.
enum class SampledObjects {
  lines,      // lines, and surfaces that were integrated, which are drawn as lines
  all,        // triangles and points, too
  integrated  // surfaces that were integrated alone
};

/// TreeOptions are those of the method `tree`.
struct TreeOptions {
  TreeBudget budget;
  LayerRule rule;
  StripOptions strips;
  SampledObjects sampled = SampledObjects::lines;

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
/// ε² bounds squared differences of view depth in world units, as in the paper, where it is given.
/// Where it is not, it is a millionth of the square of the scene's depth in this picture, so that a
/// scene of any unit is drawn alike. Lines that the scene holds are rasterized as the ribbons they
/// are, frame by frame. Beyond the paper: lines of an integrated surface are strips in its tangent
/// plane (surface_strips.h); the tree is balanced and linked from front to back (layer_tree.glsl).
/// Colours are averaged after lighting, unless `average=attributes` averages colours and normals
/// and lights the layers, as published; means of uv, which nothing is drawn by, are left out. Other
/// objects are no samples of a surface: their triangles and points are inserted once, each fragment
/// a layer that nothing is merged with, unless `sampled` says otherwise.
///
/// Accuracy: exact for scenes without lines and integrated surfaces; for these no bound, see the
/// studies tree-epsilon and progressive-oit.
const scene::MethodRow& tree_method();

}  // namespace pellucid::oit
