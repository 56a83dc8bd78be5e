// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "oit/lists/fragment_pool.h"
#include "oit/stage/stage.h"

namespace pellucid::oit {

/// FragmentLists hold every fragment of a pixel in a list, sorted: see
/// oit/methods/lists/linked_list.h. What is done with the sorted ones, front to back, is
/// list_consumer.glsl's.
class FragmentLists {
 public:
  /// A Consumer holds the screen passes that sort and consume.
  class Consumer {
   public:
    /// `resources`: what the passes bind beside the lists.
    Consumer(const Stage& stage, Defines defines, const Resources& resources = {});
    bool has_long_lists() const { return long_lists_.has_value(); }

   private:
    friend FragmentLists;
    const Stage& stage_;
    Defines defines_;
    Resources resources_;
    Program resolve_;
    struct LongListPrograms {
      Program sort, merge, blend;
    };
    const LongListPrograms& long_lists();
    std::optional<LongListPrograms> long_lists_;
  };

  /// Makes empty lists; `method` names them in messages.
  FragmentLists(Stage& stage, std::string_view method);

  /// Counts the fragments and makes a place for each. Throws WorkError when there are more than the
  /// driver's largest texture buffer holds.
  void reserve();
  std::uint64_t fragments() const { return pool_.nodes; }
  bool reserved() const { return pool_.links.bytes() > 0; }
  /// Fills the lists by a shader that calls append_fragment() of list_append.glsl for every
  /// fragment.
  void build(const GeometryProgram& program) const;
  /// Empties the lists and draws into `target`. Throws WorkError when a pixel has more layers than
  /// can be sorted.
  void consume(Consumer& consumer, const Framebuffer& target) const;

 private:
  Resources lists() const;
  void consume_long(std::uint32_t longest, Consumer& consumer, const Pass& pass) const;
  void consume_deep(std::uint32_t longest, const Consumer::LongListPrograms& programs,
                    const Pass& pass) const;
  void finish_stores() const;

  Stage& stage_;
  std::string_view method_;
  Texture heads_;
  Buffer node_count_, longest_;
  FragmentPool pool_;
  Framebuffer no_targets_;
  SampleQuery query_;
  GeometryProgram count_;
};

/// At most so many layers are sorted in registers: RUN of list_sort.glsl.
inline constexpr int most_layers_in_registers = 16;

}  // namespace pellucid::oit
