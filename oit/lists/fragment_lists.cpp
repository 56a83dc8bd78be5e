// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/lists/fragment_lists.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "oit_glsl.h"

namespace pellucid::oit {
namespace {

// llvmpipe silently ends the loops of a shader after 65535 iterations in all. Sorting and consuming
// takes about 6 for each layer: up to here one pass does it all …
constexpr std::uint32_t most_layers_at_once = 4096;
// … and deeper pixels take a pass for each level of a merge sort, at a quarter of an iteration for
// each layer.
constexpr std::uint32_t most_layers = 250'000;

}  // namespace

FragmentLists::Consumer::Consumer(const Stage& stage, Defines defines, const Resources& resources)
    : stage_(stage),
      defines_(std::move(defines)),
      resources_(resources),
      resolve_(stage.screen_program(oit_glsl::list_resolve_frag_glsl(), defines_)) {}

const FragmentLists::Consumer::LongListPrograms& FragmentLists::Consumer::long_lists() {
  if (!long_lists_) {
    long_lists_ =
        LongListPrograms{stage_.screen_program(oit_glsl::list_sort_frag_glsl(), defines_),
                         stage_.screen_program(oit_glsl::list_merge_frag_glsl(), defines_),
                         stage_.screen_program(oit_glsl::list_blend_frag_glsl(), defines_)};
    long_lists_->sort.set("most_layers", int(most_layers_at_once));
  }
  return *long_lists_;
}

FragmentLists::FragmentLists(Stage& stage, std::string_view method, const ListOptions& options)
    : stage_(stage),
      method_(method),
      most_(most_nodes(stage.gl())),
      heads_(stage.target("list heads", GL_R32UI)),
      node_count_(stage.gl(), sizeof(std::uint32_t)),
      longest_(stage.gl(), sizeof(std::uint32_t)),
      no_targets_(stage.gl(), stage.width(), stage.height()),
      query_(stage.gl()),
      count_(stage.geometry_program(oit_glsl::list_count_frag_glsl())) {
  if (options.fragments_per_pass)
    most_ = std::min(most_, std::uint64_t(*options.fragments_per_pass));
  stage.record("counters", node_count_.bytes() + longest_.bytes());
}

void FragmentLists::reserve() {
  bands_.clear();
  cut({0, stage_.height()});
  const std::uint64_t nodes = std::ranges::max(bands_, {}, &Band::fragments).fragments;
  if (nodes == pool_.nodes && pool_.bytes() > 0) return;
  pool_ = {};  // the old pool is gone before the new one is there
  pool_ = make_fragment_pool(stage_.gl(), method_, nodes);
  stage_.record("list nodes", pool_.bytes());
}

void FragmentLists::cut(const Rows& rows) {
  query_.begin();
  stage_.draw_geometry(Pass(no_targets_, {Blend::replace}).in(rows), count_);
  const std::uint64_t fragments = query_.end();
  if (fragments <= most_) {
    bands_.push_back({rows, fragments});
    return;
  }
  if (rows.count == 1)
    throw WorkError(
        fmt::format("{}: a row of the picture has {} fragments, but {} are kept at "
                    "once; draw a narrower picture",
                    method_, fragments, most_));
  const int half = rows.count / 2;
  cut({rows.first, half});
  cut({rows.first + half, rows.count - half});
}

std::uint64_t FragmentLists::fragments() const {
  std::uint64_t sum = 0;
  for (const Band& band : bands_) sum += band.fragments;
  return sum;
}

std::string FragmentLists::describe() const {
  if (bands_.empty()) return "list nodes: none before the first picture counts its fragments";
  if (bands_.size() == 1)
    return fmt::format("list nodes: {}, as many as were counted", pool_.nodes);
  return fmt::format("list nodes: {} for {} fragments, which {} bands of rows take in turn",
                     pool_.nodes, fragments(), bands_.size());
}

void FragmentLists::build(const GeometryProgram& program, const Band& band) const {
  heads_.clear(0);
  node_count_.clear(0);
  const Resource counter = node_count_.as_atomic_counter(bindings::node_counter);
  const Pass pass(no_targets_, {Blend::replace}, lists() + counter);
  stage_.draw_geometry(pass.in(band.rows), program);
  finish_stores();
}

Resources FragmentLists::lists() const {
  return pool_.resources() + heads_.as_image(bindings::heads_image);
}

void FragmentLists::consume(Consumer& consumer, const Framebuffer& target, const Band& band) const {
  longest_.clear(0);
  const Resource longest_block = longest_.as_storage_block(bindings::longest_storage);
  const Pass pass =
      Pass(target, {Blend::replace}, lists() + longest_block + consumer.resources_).in(band.rows);
  stage_.draw_screen(pass, consumer.resolve_);
  finish_stores();
  if (const std::uint32_t longest = longest_.read_word(0)) consume_long(longest, consumer, pass);
}

void FragmentLists::consume_long(std::uint32_t longest, Consumer& consumer,
                                 const Pass& pass) const {
  if (longest > most_layers)
    throw WorkError(fmt::format("{}: a pixel has {} layers or more; sorted are at most {}", method_,
                                longest, most_layers));
  const Consumer::LongListPrograms& programs = consumer.long_lists();
  stage_.draw_screen(pass, programs.sort);
  finish_stores();
  if (longest > most_layers_at_once) consume_deep(longest, programs, pass);
}

void FragmentLists::consume_deep(std::uint32_t longest, const Consumer::LongListPrograms& programs,
                                 const Pass& pass) const {
  const Pass merging = Pass(no_targets_, {Blend::replace}, lists()).in(*pass.rows);
  for (std::uint32_t length = 1; length < longest; length *= 2) {
    programs.merge.set("length_of_runs", int(length));
    stage_.draw_screen(merging, programs.merge);
    finish_stores();
  }
  stage_.draw_screen(pass, programs.blend);
}

void FragmentLists::finish_stores() const {
  stage_.gl().MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace pellucid::oit
