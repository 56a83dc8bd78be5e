// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "oit/methods/tree/surface_strips.h"
#include "oit/shapes/batch.h"

namespace pellucid::oit {

/// LineSources are the objects of a scene that are drawn line by line: surfaces that were
/// integrated from a seed curve, whose strips are made when they are asked for, and lines that the
/// scene holds. A number of lines from all of them together is a batch, to which each gives in
/// proportion to what it has.
class LineSources {
 public:
  /// Takes the surface that an object was integrated from; `scene` and `object` have to outlive it.
  /// Returns the bytes that it keeps.
  std::uint64_t add_surface(const scene::SceneObject& object, const scene::Scene& scene,
                            const scene::DepthRange& range, std::uint64_t lines,
                            const StripOptions& options, const PrimitiveRange& place);
  /// Takes the lines of an object, which has to outlive it. They come in an order that spreads over
  /// the object from the first ones on: neighbours in a file are often neighbours in space.
  void add_lines(const scene::SceneObject& object, const PrimitiveRange& place);

  bool empty() const { return sources_.empty(); }
  /// Returns how many lines there are in all.
  std::uint64_t line_count() const;
  /// Returns the places of the objects of a batch in the order of the scene.
  const std::vector<PrimitiveRange>& places() const { return places_; }

  /// A LineBatch is some of the lines, an object of each source.
  struct LineBatch {
    std::vector<scene::SceneObject> objects;
    std::uint64_t lines = 0;
  };
  /// Returns the lines from `first` on, `count` of them up to one of every source.
  LineBatch batch(std::uint64_t first, std::uint64_t count) const;

 private:
  struct Source {
    std::uint64_t lines;
    std::function<scene::SceneObject(std::uint64_t first, std::uint64_t count)> make;
  };
  std::vector<Source> sources_;
  std::vector<PrimitiveRange> places_;
};

}  // namespace pellucid::oit
