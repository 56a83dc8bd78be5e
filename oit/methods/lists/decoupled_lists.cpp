// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/lists/decoupled_lists.h"

#include "oit/gl/bindings.h"
#include "oit/lists/fragment_lists.h"
#include "oit/opacity/energy_block.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

/// Steps 1 to 3, by lists.
struct ExactOpacity {
  ExactOpacity(Stage& stage, const DecoupledListsOptions& options)
      : elements(stage, options.elements),
        energy(EnergyBlock(scene::energy_weights(options.energy, stage.scene().energy))
                   .buffer(stage.gl())),
        build(stage.geometry_program(oit_glsl::decoupled_lists_build_frag_glsl(),
                                     {{"IMPORTANCE", 1}})),
        optimize(stage, {{"OPTIMIZE_OPACITY", 1}},
                 {elements.image(), energy.as_uniform_block(bindings::energy_block)}),
        no_targets(stage.gl(), stage.width(), stage.height()) {}

  void find(const FragmentLists& lists) {
    elements.begin();
    lists.consume(optimize, no_targets);
  }

  ElementOpacity elements;
  Buffer energy;
  GeometryProgram build;
  FragmentLists::Consumer optimize;
  Framebuffer no_targets;
};

class DecoupledLists final : public OitMethod {
 public:
  DecoupledLists(Stage& stage, const DecoupledListsOptions& options)
      : lists_(stage, "decoupled-lists") {
    FragmentOpacity opacity;
    if (has_importance(stage.scene())) {
      stage.upload_importance();
      opacity_.emplace(stage, options);
      opacity = ElementOpacity::fragment_opacity();
    }
    build_ = stage.geometry_program(oit_glsl::list_build_frag_glsl(), {}, opacity);
    composite_.emplace(stage, Defines());
  }

  void draw(Frame& frame) override {
    frame.step("count", [&] { lists_.reserve(); });
    if (opacity_) {
      frame.step("list importance", [&] { lists_.build(opacity_->build); });
      frame.step("optimize opacity", [&] { opacity_->find(lists_); });
      frame.step("smooth opacity", [&] { opacity_->elements.smooth_and_interpolate(); });
    }
    frame.step("list colours", [&] { lists_.build(build_); });
    frame.step("composite", [&] { lists_.consume(*composite_, frame.picture()); });
    frame.stats().fragments = frame.stats().stored = lists_.fragments();
  }

  std::vector<std::string> explain() const override {
    return {opacity_ ? opacity_->elements.describe() : nothing_is_important};
  }

 private:
  FragmentLists lists_;
  std::optional<ExactOpacity> opacity_;
  GeometryProgram build_;
  std::optional<FragmentLists::Consumer> composite_;
};

}  // namespace

const OptionTable<DecoupledListsOptions>& decoupled_lists_options() {
  static const OptionTable<DecoupledListsOptions> table{
      part(&DecoupledListsOptions::energy, scene::energy_options()),
      part(&DecoupledListsOptions::elements, element_options())};
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
                   .optimizes_opacity = true},
      .bytes_per_pixel = "4 + 32 per layer",
      .make = make_oit<DecoupledLists, decoupled_lists_options>};
  return row;
}

}  // namespace pellucid::oit
