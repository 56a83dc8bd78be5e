// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/lists/decoupled_lists.h"

#include "oit/gl/bindings.h"
#include "oit/lists/fragment_lists.h"
#include "oit/opacity/energy_block.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

Buffer energy_buffer(const Stage& stage, const DecoupledListsOptions& options) {
  return EnergyBlock(scene::energy_weights(options.energy, stage.scene().energy))
      .buffer(stage.gl());
}

/// Steps 1 to 3, by lists.
struct ExactOpacity {
  ExactOpacity(Stage& stage, const ElementOptions& options, const Resource& energy)
      : elements(stage, options),
        build(stage.geometry_program(oit_glsl::decoupled_lists_build_frag_glsl(),
                                     {{"IMPORTANCE", 1}})),
        optimize(stage, {{"OPTIMIZE_OPACITY", 1}}, {elements.image(), energy}),
        no_targets(stage.gl(), stage.width(), stage.height()) {}

  /// Lowers the opacities of elements by what the lists of a band hold.
  void find(const FragmentLists& lists, const FragmentLists::Band& band) {
    lists.consume(optimize, no_targets, band);
  }

  ElementOpacity elements;
  GeometryProgram build;
  FragmentLists::Consumer optimize;
  Framebuffer no_targets;
};

class DecoupledLists final : public OitMethod {
 public:
  DecoupledLists(Stage& stage, const DecoupledListsOptions& options)
      : lists_(stage, "decoupled-lists", options.lists),
        important_(has_importance(stage.scene())),
        energy_(energy_buffer(stage, options)) {
    const Resource energy = energy_.as_uniform_block(bindings::energy_block);
    const bool fragments = important_ && options.per == OpacityUnit::fragment;
    if (important_) stage.upload_importance();
    if (important_ && !fragments) elements_.emplace(stage, options.elements, energy);
    build_ = stage.geometry_program(
        oit_glsl::list_build_frag_glsl(), fragments ? Defines{{"IMPORTANCE", 1}} : Defines{},
        elements_ ? ElementOpacity::fragment_opacity() : FragmentOpacity{});
    if (fragments)
      composite_.emplace(stage, Defines{{"OPTIMIZE_FRAGMENTS", 1}}, Resources{energy});
    else
      composite_.emplace(stage, Defines{});
  }

  void draw(Frame& frame) override {
    frame.step("count", [&] { lists_.reserve(); });
    if (elements_) {
      frame.step("list importance", [&] { elements_->elements.begin(); });
      for (const FragmentLists::Band& band : lists_.bands()) {
        frame.step("list importance", [&] { lists_.build(elements_->build, band); });
        frame.step("optimize opacity", [&] { elements_->find(lists_, band); });
      }
      frame.step("smooth opacity", [&] { elements_->elements.smooth_and_interpolate(); });
    }
    for (const FragmentLists::Band& band : lists_.bands()) {
      frame.step("list colours", [&] { lists_.build(build_, band); });
      frame.step("composite", [&] { lists_.consume(*composite_, frame.picture(), band); });
    }
    frame.stats().fragments = frame.stats().stored = lists_.fragments();
  }

  std::optional<scene::OptimizedOpacities> optimized_opacities() const override {
    if (!elements_) return std::nullopt;
    return elements_->elements.found();
  }

  std::vector<std::string> explain() const override {
    if (elements_) return {elements_->elements.describe()};
    return {important_ ? every_fragment_is_optimized : nothing_is_important};
  }

 private:
  FragmentLists lists_;
  bool important_;
  Buffer energy_;
  std::optional<ExactOpacity> elements_;
  GeometryProgram build_;
  std::optional<FragmentLists::Consumer> composite_;
};

}  // namespace

const OptionTable<DecoupledListsOptions>& decoupled_lists_options() {
  static const OptionTable<DecoupledListsOptions> table{
      part(&DecoupledListsOptions::energy, scene::energy_options()),
      opacity_unit_option(&DecoupledListsOptions::per),
      part(&DecoupledListsOptions::elements, element_options()),
      part(&DecoupledListsOptions::lists, list_options())};
  return table;
}

const scene::MethodRow& decoupled_lists_method() {
  static const scene::MethodRow row{
      .name = "decoupled-lists",
      .title = "Decoupled opacity optimization (linked lists)",
      .citation =
          "Guenther, Theisel and Gross 2017, Decoupled opacity "
          "optimization for points, lines and "
          "surfaces, CGF 36(2)",
      .equations = "Baeza Rojo et al. 2019, Eqs. 2 and 12, section 2.2.4",
      .checked_against =
          "Baeza Rojo et al. 2019, who restate the method; not the paper of 2017 itself",
      .parameters = decoupled_lists_options().specs(),
      .promises = {.exact_without_importance = true,
                   .order_spread = 1e-3,
                   .convex_hull = true,
                   .optimizes_opacity = true,
                   .optimizes_vertices = true},
      .bytes_per_pixel = "4 + 32 per layer, of fragments-per-pass at most",
      .make = make_oit<DecoupledLists, decoupled_lists_options>};
  return row;
}

}  // namespace pellucid::oit
