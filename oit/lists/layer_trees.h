// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/options/option_table.h"
#include "oit/lists/fragment_pool.h"
#include "oit/stage/stage.h"

namespace pellucid::oit {

/// A LayerMerge says which layer takes a fragment, of those within ε; see find_place() of
/// layer_tree.glsl.
enum class LayerMerge { nearest, first_met };

/// A LayerRule says how fragments become layers.
struct LayerRule {
  double epsilon2 = 1e-6;  // largest squared difference of depths d within a layer, exclusive
  LayerMerge merge = LayerMerge::nearest;

  bool operator==(const LayerRule&) const = default;
};
/// Returns the table of LayerRule.
const OptionTable<LayerRule>& layer_rule_options();

/// LayerTrees are one tree of layers per pixel (layer_tree.glsl), which keeps what every frame
/// adds.
class LayerTrees {
 public:
  LayerTrees(Stage& stage, const LayerRule& rule);

  /// Empties all trees.
  void clear();
  /// Rasterizes `geometry` into lists of fragments. If they are `crossings`, each is a layer by
  /// itself.
  void rasterize(const Geometry& geometry, bool crossings);
  /// Puts the fragments that were rasterized into the trees.
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
  void reserve(std::uint64_t layers);
  Resources lists() const;
  Resources trees() const;
  void finish_stores() const;

  Stage& stage_;
  Texture heads_, trees_;
  Buffer fragment_count_, layer_count_, unfinished_;
  FragmentPool pool_;
  BufferTexture nodes_, links_, colors_;  // see layer_nodes.glsl
  std::uint64_t capacity_ = 0;            // of these, without layer 0
  Framebuffer no_targets_;
  GeometryProgram build_;
  Program insert_, composite_;
  bool crossings_ = false;
  std::uint64_t frame_fragments_ = 0, fragments_ = 0, layers_ = 0;
};

}  // namespace pellucid::oit
