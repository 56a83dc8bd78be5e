// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "oit/lists/fragment_pool.h"
#include "oit/lists/list_options.h"
#include "oit/stage/stage.h"

namespace pellucid::oit {

/// FragmentLists hold every fragment of a pixel in a list, sorted: see
/// oit/methods/lists/linked_list.h. What is done with the sorted ones, front to back, is
/// list_consumer.glsl's.
///
/// What does not fit into the pool is drawn by bands of rows, one after the other: a band's
/// fragments lie in the pool until they are consumed, and each band is a pass over the scene. A
/// pixel's list is the same in any band, and so is the picture.
class FragmentLists {
 public:
  /// A Band is some of the picture's rows.
  struct Band {
    Rows rows;
    std::uint64_t fragments;
  };

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
  FragmentLists(Stage& stage, std::string_view method, const ListOptions& options);

  /// Counts the fragments, cuts the picture into bands, and makes a place for each fragment of the
  /// fullest one. Throws WorkError when a row has more fragments than are kept at once.
  void reserve();
  /// Returns the bands, which are all of the picture, from its top; none before reserve().
  const std::vector<Band>& bands() const { return bands_; }
  std::uint64_t fragments() const;  // of all bands
  /// Says in a line how many nodes there are.
  std::string describe() const;
  /// Fills the lists of a band by a shader that calls append_fragment() of list_append.glsl for
  /// every fragment.
  void build(const GeometryProgram& program, const Band& band) const;
  /// Empties the lists of a band and draws into its rows of `target`. Throws WorkError when a pixel
  /// has more layers than can be sorted.
  void consume(Consumer& consumer, const Framebuffer& target, const Band& band) const;

 private:
  /// Appends the bands that these rows are cut into.
  void cut(const Rows& rows);
  Resources lists() const;
  void consume_long(std::uint32_t longest, Consumer& consumer, const Pass& pass) const;
  void consume_deep(std::uint32_t longest, const Consumer::LongListPrograms& programs,
                    const Pass& pass) const;
  void finish_stores() const;

  Stage& stage_;
  std::string_view method_;
  std::uint64_t most_;  // fragments at once
  std::vector<Band> bands_;
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
