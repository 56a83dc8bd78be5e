// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/methods/lists/linked_list.h"

#include <fmt/format.h>

#include "oit/lists/fragment_lists.h"
#include "oit/stage/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

class LinkedList final : public OitMethod {
 public:
  LinkedList(Stage& stage, const ListOptions& options, const FragmentOpacity& opacity = {})
      : lists_(stage, "linked-list", options),
        build_(stage.geometry_program(oit_glsl::list_build_frag_glsl(), {}, opacity)),
        composite_(stage, {}) {}

  void draw(Frame& frame) override {
    frame.step("count", [&] { lists_.reserve(); });
    for (const FragmentLists::Band& band : lists_.bands()) {
      frame.step("build", [&] { lists_.build(build_, band); });
      frame.step("sort and composite", [&] { lists_.consume(composite_, frame.picture(), band); });
    }
    frame.stats().fragments = frame.stats().stored = lists_.fragments();
  }

  std::vector<std::string> explain() const override {
    return {lists_.describe(),
            composite_.has_long_lists()
                ? "long lists: sorted by passes of their own"
                : fmt::format("long lists: left out, no pixel was seen to have more than "
                              "{} layers",
                              most_layers_in_registers)};
  }

 private:
  FragmentLists lists_;
  GeometryProgram build_;
  FragmentLists::Consumer composite_;
};

}  // namespace

std::unique_ptr<OitMethod> make_linked_list(Stage& stage, const FragmentOpacity& opacity) {
  return std::make_unique<LinkedList>(stage, ListOptions(), opacity);
}

const scene::MethodRow& linked_list_method() {
  static const scene::MethodRow row{
      .name = "linked-list",
      .title = "Linked lists",
      .citation =
          "Yang, Hensley, Gruen and Thibieroz 2010, Real-time "
          "concurrent linked list "
          "construction on the GPU, CGF 29(4)",
      .equations = "sections 3 and 4: construction, sorting and blending",
      .checked_against = "not recorded",
      .parameters = list_options().specs(),
      .promises = {.exact = true, .order_independent = true, .convex_hull = true},
      .bytes_per_pixel = "4 + 32 per layer, of fragments-per-pass at most",
      .make = make_oit<LinkedList, list_options>};
  return row;
}

}  // namespace pellucid::oit
