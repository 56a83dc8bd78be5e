#include "oit/methods/linked_list.h"

#include <fmt/format.h>

#include <optional>

#include "core/error.h"
#include "oit/fragment_pool.h"
#include "oit/oit_renderer.h"
#include "oit_glsl.h"

namespace pellucid {
namespace {

// Layers that are sorted in registers: RUN of list_sort.glsl.
constexpr int most_layers_in_registers = 16;
// llvmpipe silently ends the loops of a shader after 65535 iterations in all. Sorting and
// compositing takes about 6 for each layer: up to here one pass does it all …
constexpr std::uint32_t most_layers_at_once = 4096;
// … and deeper pixels take a pass for each level of a merge sort, at a quarter of an iteration for
// each layer.
constexpr std::uint32_t most_layers = 250'000;

/// Programs for pixels of more layers than registers hold.
struct LongListPrograms {
  explicit LongListPrograms(const Stage& stage)
      : sort(stage.screen_program(oit_glsl::linked_list_sort_frag_glsl())),
        merge(stage.screen_program(oit_glsl::linked_list_merge_frag_glsl())),
        blend(stage.screen_program(oit_glsl::linked_list_blend_frag_glsl())) {
    sort.set("most_layers", int(most_layers_at_once));
  }
  Program sort, merge, blend;
};

class LinkedList final : public OitMethod {
 public:
  LinkedList(Stage& stage, const Parameters&)
      : stage_(stage),
        heads_(stage.target("list heads", GL_R32UI)),
        node_count_(stage.gl(), sizeof(std::uint32_t)),
        longest_(stage.gl(), sizeof(std::uint32_t)),
        no_targets_(stage.gl(), stage.width(), stage.height()),
        query_(stage.gl()),
        count_(stage.geometry_program(oit_glsl::linked_list_count_frag_glsl())),
        build_(stage.geometry_program(oit_glsl::linked_list_build_frag_glsl())),
        resolve_(stage.screen_program(oit_glsl::linked_list_resolve_frag_glsl())) {
    stage.record("counters", node_count_.bytes() + longest_.bytes());
  }

  void draw(Frame& frame) override {
    frame.step("count", [&] { reserve(count_fragments()); });
    frame.step("build", [&] { build(); });
    frame.step("sort and composite", [&] { resolve(frame.picture()); });
    frame.stats().fragments = pool_.nodes;
  }

  std::vector<std::string> explain() const override {
    return {pool_.links.bytes()
                ? fmt::format("list nodes: {}, as many as were counted", pool_.nodes)
                : "list nodes: none before the first picture counts its fragments",
            long_lists_ ? "long lists: sorted by passes of their own"
                        : fmt::format("long lists: left out, no pixel was seen to have more than "
                                      "{} layers",
                                      most_layers_in_registers)};
  }

 private:
  std::uint64_t count_fragments() const {
    stage_.begin_pass(no_targets_, {Blend::replace});
    query_.begin();
    stage_.draw_geometry(count_);
    return query_.end();
  }

  void reserve(std::uint64_t fragments) {
    if (fragments == pool_.nodes && pool_.links.bytes() > 0) return;
    pool_ = {};  // the old pool is gone before the new one is there
    pool_ = make_fragment_pool(stage_.gl(), "linked-list", fragments);
    stage_.record("list nodes", pool_.bytes());
  }

  void build() const {
    heads_.clear(0);
    node_count_.clear(0);
    heads_.bind_image(0);
    pool_.bind();
    node_count_.bind_base(GL_ATOMIC_COUNTER_BUFFER, 0);
    stage_.begin_pass(no_targets_, {Blend::replace});
    stage_.draw_geometry(build_);
    finish_stores();
  }

  void resolve(const Framebuffer& picture) {
    longest_.clear(0);
    longest_.bind_base(GL_SHADER_STORAGE_BUFFER, 0);
    stage_.begin_pass(picture, {Blend::replace});
    stage_.draw_screen(resolve_);
    finish_stores();
    if (const std::uint32_t longest = longest_.read_word(0)) resolve_long(longest, picture);
  }

  void resolve_long(std::uint32_t longest, const Framebuffer& picture) {
    if (longest > most_layers)
      throw WorkError(
          fmt::format("linked-list: a pixel has {} layers or more; sorted are at most {}", longest,
                      most_layers));
    if (!long_lists_) long_lists_.emplace(stage_);
    stage_.draw_screen(long_lists_->sort);
    finish_stores();
    if (longest > most_layers_at_once) resolve_deep(longest, picture);
  }

  void resolve_deep(std::uint32_t longest, const Framebuffer& picture) const {
    stage_.begin_pass(no_targets_, {Blend::replace});
    for (std::uint32_t length = 1; length < longest; length *= 2) {
      long_lists_->merge.set("length_of_runs", int(length));
      stage_.draw_screen(long_lists_->merge);
      finish_stores();
    }
    stage_.begin_pass(picture, {Blend::replace});
    stage_.draw_screen(long_lists_->blend);
  }

  void finish_stores() const {
    stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  }

  Stage& stage_;
  Texture heads_;
  Buffer node_count_, longest_;
  FragmentPool pool_;
  Framebuffer no_targets_;
  SampleQuery query_;
  GeometryProgram count_, build_;
  Program resolve_;
  std::optional<LongListPrograms> long_lists_;
};

}  // namespace

const MethodRow& linked_list_method() {
  static constexpr MethodRow row{
      .name = "linked-list",
      .title = "Linked lists",
      .citation =
          "Yang, Hensley, Gruen and Thibieroz 2010, Real-time concurrent linked list "
          "construction on the GPU, CGF 29(4)",
      .equations = "sections 3 and 4: construction, sorting and blending",
      .parameters = {},
      .promises = {.exact = true, .order_independent = true, .convex_hull = true},
      .bytes_per_pixel = "4 + 32 per layer",
      .make = make_oit<LinkedList>};
  return row;
}

}  // namespace pellucid
