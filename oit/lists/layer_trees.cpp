// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/lists/layer_trees.h"

#include "core/error.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// llvmpipe silently ends the loops of a shader after 65535 iterations, counted over all 8 pixels
// that it runs at once: what a pixel may take of them before it waits for the next pass. Its last
// search may take `longest_path` of layer_tree.glsl more, so that 8 pixels stay below 8 * 8000.
constexpr int most_steps = 4000;

/// Makes room for `bytes`; what is there stays.
void grow(const Gl& gl, GLenum format, std::uint64_t bytes, BufferTexture& texture) {
  BufferTexture larger(gl, format, bytes);
  if (texture.bytes() > 0)
    gl.CopyNamedBufferSubData(texture.buffer().id(), larger.buffer().id(), 0, 0,
                              GLsizeiptr(texture.bytes()));
  texture = std::move(larger);
}

/// Whether layers are lit after their fragments are merged, where the rule asks for it.
bool lights_layers(const scene::Scene& scene) {
  if (!scene::common_lighting(scene))
    throw InputError(
        "average=attributes: a layer may be of objects that are lit otherwise; accepted: one "
        "\"lighting\" for all objects, or average=color");
  return scene::is_lit(scene);
}

}  // namespace

const OptionTable<LayerRule>& layer_rule_options() {
  static const OptionTable<LayerRule> table{
      number("epsilon2", &LayerRule::epsilon2,
             {.min = 0,
              .unit = "world units squared",
              .help = "fragments within this squared difference of view depth are one layer; "
                      "default: 1e-6 of the squared depth of what is in the picture"}),
      choice("unit", &LayerRule::unit,
             {{"view", EpsilonUnit::view}, {"normalized", EpsilonUnit::normalized}},
             "of epsilon2: view depth in world units, or d, the depth range of what is in the "
             "picture being 1"),
      choice("merge", &LayerRule::merge,
             {{"nearest", LayerMerge::nearest}, {"first", LayerMerge::first_met}},
             "into the nearest layer within epsilon, or the first met on the search path"),
      choice("average", &LayerRule::average,
             {{"color", LayerAverage::color}, {"attributes", LayerAverage::attributes}},
             "of a layer's fragments: their lit colours, or colours and normals, lit afterwards")};
  return table;
}

// d is linear in view depth.
Epsilon epsilon_of(const LayerRule& rule, const scene::DepthRange& range) {
  const double length = range.far - range.near;
  if (rule.epsilon2 && rule.unit == EpsilonUnit::view)
    return {*rule.epsilon2, *rule.epsilon2 / length / length};
  const double normalized2 = rule.epsilon2.value_or(LayerRule::default_epsilon2);
  return {normalized2 * length * length, normalized2};
}

LayerTrees::LayerTrees(Stage& stage, double epsilon2, const LayerRule& rule)
    : stage_(stage),
      has_normals_(rule.average == LayerAverage::attributes && lights_layers(stage.scene())),
      heads_(stage.target("list heads", GL_R32UI)),
      trees_(stage.target("trees", GL_RG32UI)),
      fragment_count_(stage.gl(), sizeof(std::uint32_t)),
      layer_count_(stage.gl(), sizeof(std::uint32_t)),
      unfinished_(stage.gl(), 2 * sizeof(std::uint32_t)),
      pool_(make_fragment_pool(stage.gl(), "tree", 0)),
      no_targets_(stage.gl(), stage.width(), stage.height()),
      build_(stage.geometry_program(oit_glsl::list_build_frag_glsl(),
                                    has_normals_ ? Defines{{"LIT_LATER", 1}} : Defines{})),
      insert_(stage.screen_program(oit_glsl::tree_insert_frag_glsl(), defines())),
      composite_(stage.screen_program(oit_glsl::tree_composite_frag_glsl(), defines())) {
  stage.record("counters", fragment_count_.bytes() + layer_count_.bytes() + unfinished_.bytes());
  insert_.set("epsilon2", float(epsilon2));
  insert_.set("first_met", int(rule.merge == LayerMerge::first_met));
  insert_.set("most_steps", most_steps);
  reserve(1);
}

Defines LayerTrees::defines() const {
  if (!has_normals_) return {};
  Defines defines = stage_.geometry().defines();
  defines.emplace_back("AVERAGE_ATTRIBUTES", 1);
  return defines;
}

void LayerTrees::clear() {
  trees_.clear(0);
  layer_count_.clear(0);
  frame_fragments_ = fragments_ = layers_ = 0;
}

// The fragments are not counted first: a pool that was too small grows, and the pass is drawn once
// more. What did not fit was only counted.
void LayerTrees::rasterize(const Geometry& geometry, bool crossings) {
  crossings_ = crossings;
  for (;;) {
    heads_.clear(0);
    fragment_count_.clear(0);
    const Resource counter = fragment_count_.as_atomic_counter(bindings::node_counter);
    stage_.draw_geometry({no_targets_, {Blend::replace}, lists() + counter}, build_, geometry);
    finish_stores();
    frame_fragments_ = fragment_count_.read_word(0);
    if (frame_fragments_ <= pool_.nodes) break;
    const std::uint64_t nodes = frame_fragments_ + frame_fragments_ / 4;
    pool_ = {};  // the old pool is gone before the new one is there
    pool_ = make_fragment_pool(stage_.gl(), "tree", nodes);
    stage_.record("list nodes", pool_.bytes());
  }
  fragments_ += frame_fragments_;
}

void LayerTrees::reserve(std::uint64_t layers) {
  if (layers <= capacity_) return;
  check_texel_count(stage_.gl(), "tree", layers, "layers");
  // By a quarter, so that all growing together copies a layer five times at most; the first ones
  // at once.
  capacity_ = std::max(layers, capacity_ + capacity_ / 4 + 256);
  const std::uint64_t n = capacity_ + 1;
  grow(stage_.gl(), GL_RGBA32UI, 16 * n, nodes_);
  grow(stage_.gl(), GL_RG32UI, 8 * n, links_);
  grow(stage_.gl(), GL_RGBA32F, 16 * n, colors_);
  if (has_normals_) grow(stage_.gl(), GL_RGBA32F, 16 * n, normals_);
  stage_.record("layers", nodes_.bytes() + links_.bytes() + colors_.bytes() + normals_.bytes());
}

// How many fragments become layers is not known before they are merged: a pixel without room for
// one stops, and as many as have stopped are made room for at least.
void LayerTrees::insert() {
  insert_.set("crossings", int(crossings_));
  do {
    unfinished_.clear(0);
    insert_.set("capacity", std::uint32_t(capacity_));
    const Resource counter = layer_count_.as_atomic_counter(bindings::layer_counter);
    stage_.draw_screen({no_targets_, {Blend::replace}, lists() + trees() + counter}, insert_);
    finish_stores();
    if (unfinished_.read_word(1) > 0)
      throw WorkError(
          "tree: a search path is longer than 4000 layers, and merge=first does not balance the "
          "tree; use merge=nearest, or a larger epsilon2");
    const std::uint64_t wanted = layer_count_.read_word(0);
    layers_ = std::min(wanted, capacity_);
    if (wanted <= capacity_) continue;
    layer_count_.clear(std::uint32_t(capacity_));
    reserve(wanted);
  } while (unfinished_.read_word(0) > 0);
}

void LayerTrees::composite(const Framebuffer& picture) const {
  unfinished_.clear(0);
  const Resources view = has_normals_ ? stage_.geometry().resources() : Resources{};
  stage_.draw_screen({picture, {Blend::replace}, trees() + view}, composite_);
  finish_stores();
  if (unfinished_.read_word(0) > 0)
    throw WorkError("tree: a pixel has more than 500000 layers; draw a smaller picture");
}

Resources LayerTrees::lists() const {
  return pool_.resources() + heads_.as_image(bindings::heads_image);
}

Resources LayerTrees::trees() const {
  Resources all{trees_.as_image(bindings::trees_image), nodes_.as_image(bindings::layers_image),
                links_.as_image(bindings::layer_links_image),
                colors_.as_image(bindings::layer_colors_image),
                unfinished_.as_storage_block(bindings::unfinished_storage)};
  if (has_normals_) all.add(normals_.as_image(bindings::layer_normals_image));
  return all;
}

void LayerTrees::finish_stores() const {
  stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

// Counts in float are exact up to 2^24 layers.
LayerTrees::Counts LayerTrees::count() const {
  const Texture target(stage_.gl(), GL_RG32F, stage_.width(), stage_.height());
  const Framebuffer framebuffer(stage_.gl(), {{target}});
  const Program program = stage_.screen_program(oit_glsl::tree_count_frag_glsl());
  stage_.draw_screen({framebuffer, {Blend::replace}, trees()}, program);
  std::vector<glm::vec2> pixels(stage_.pixel_count());
  target.read(GL_RG, GL_FLOAT, pixels.size() * sizeof pixels[0], pixels.data());
  Counts counts{CountImage(stage_.width(), stage_.height()), 0, 0};
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    counts.layers.pixels[i] = std::uint32_t(pixels[i].x);
    counts.out_of_order += std::uint64_t(pixels[i].y);
    counts.pixels_out_of_order += pixels[i].y > 0;
  }
  return counts;
}

}  // namespace pellucid::oit
