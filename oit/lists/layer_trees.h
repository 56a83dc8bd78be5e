// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/options/option_table.h"
#include "oit/lists/fragment_pool.h"
#include "oit/stage/stage.h"
#include "scene/view_depth.h"

namespace pellucid::oit {

/// A LayerMerge says which layer takes a fragment, of those within ε; see find_place() of
/// layer_tree.glsl.
enum class LayerMerge { nearest, first_met };

/// A LayerAverage says what a layer's means are of: of lit colours; or, as published, of colours
/// and normals, so that layers are lit after they are merged.
enum class LayerAverage { color, attributes };

/// An EpsilonUnit is what the depths are measured in whose squared difference ε² bounds: world
/// units along the viewing axis, or d.
enum class EpsilonUnit { view, normalized };

/// A LayerRule says how fragments become layers.
struct LayerRule {
  /// The largest squared difference of depths within a layer, exclusive, in the square of `unit`;
  /// if it is not set, `default_epsilon2` of d, a thousandth of the scene's depth: that of view
  /// depths which is right in one scene is nonsense in another of other units.
  std::optional<double> epsilon2;
  EpsilonUnit unit = EpsilonUnit::view;
  LayerMerge merge = LayerMerge::nearest;
  LayerAverage average = LayerAverage::color;

  static constexpr double default_epsilon2 = 1e-6;  // of d

  bool operator==(const LayerRule&) const = default;
};
/// An Epsilon is the rule's ε² in both units.
struct Epsilon {
  double view2 = 0;        // world units squared
  double normalized2 = 0;  // of d
};
/// Returns the ε² of a rule in a scene of that depth range.
Epsilon epsilon_of(const LayerRule& rule, const scene::DepthRange& range);

/// Returns the table of LayerRule.
const OptionTable<LayerRule>& layer_rule_options();

/// LayerTrees are one tree of layers per pixel (layer_tree.glsl), which keeps what every frame
/// adds.
class LayerTrees {
 public:
  /// Merges what lies within `epsilon2`, a squared difference of d, as the rule says, whose own
  /// ε² is not looked at.
  LayerTrees(Stage& stage, double epsilon2, const LayerRule& rule);

  /// Empties all trees.
  void clear();
  /// Rasterizes `geometry` into lists of fragments. If they are `crossings`, each is a layer by
  /// itself.
  void rasterize(const Geometry& geometry, bool crossings);
  /// Puts the fragments that were rasterized into the trees. Throws WorkError when a path of
  /// `first_met` is longer than 4000 layers.
  void insert();
  /// Composites each pixel's layers front to back into `picture`. Throws WorkError when a pixel has
  /// more layers than a shader's loop reaches.
  void composite(const Framebuffer& picture) const;

  std::uint64_t fragments() const { return fragments_; }  // since clear()
  std::uint64_t layers() const { return layers_; }

  /// Counts say how many layers there are, and how many of them lie in the wrong order.
  struct Counts {
    CountImage layers;               // per pixel
    std::uint64_t out_of_order = 0;  // layers that lie nearer than the layer in front of them
    std::uint64_t pixels_out_of_order = 0;
  };
  /// Counts the layers of all pixels.
  Counts count() const;

 private:
  Defines defines() const;
  void reserve(std::uint64_t layers);
  Resources lists() const;
  Resources trees() const;
  void finish_stores() const;

  Stage& stage_;
  bool has_normals_;
  Texture heads_, trees_;
  Buffer fragment_count_, layer_count_;
  Buffer unfinished_;  // pixels that wait; pixels whose search path is too long
  FragmentPool pool_;
  BufferTexture nodes_, links_, colors_, normals_;  // see layer_nodes.glsl
  std::uint64_t capacity_ = 0;                      // of these, without layer 0
  Framebuffer no_targets_;
  GeometryProgram build_;
  Program insert_, composite_;
  bool crossings_ = false;
  std::uint64_t frame_fragments_ = 0, fragments_ = 0, layers_ = 0;
};

}  // namespace pellucid::oit
