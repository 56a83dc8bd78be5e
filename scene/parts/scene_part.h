// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of a scene's primitives, so that each may be drawn by itself and their crossings merged.

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace pellucid::scene {

/// The largest PartNumber::count.
constexpr int most_parts = 1 << 16;

/// A PartNumber says which of how many parts of a scene's primitives is meant.
struct PartNumber {
  int part = 1;   // 1 … count
  int count = 1;  // 1 … most_parts

  bool operator==(const PartNumber&) const = default;
};

/// A PartOf says of which objects a part has a share: of all, or of those that are not opaque,
/// while opaque ones stay whole, since they hide what other parts hold.
enum class PartOf { all_objects, transparent_objects };

/// A Share is the elements begin … end - 1 of an object.
struct Share {
  std::uint64_t begin = 0, end = 0;
};

/// Returns how many of an object's elements are shared out over the parts: triangles, points or
/// lines; 0 of an isosurface, whose cells are, by share_of_cells(), where they are found, and of an
/// opaque object that `of` keeps whole.
std::uint64_t shared_elements(const SceneObject& object, PartOf of);

/// Returns which elements of an object a part holds, `counts` being shared_elements() of all
/// objects. They stand in one row, object after object, of which each part holds a piece; pieces
/// have no element in common, leave none out, and differ by one element at most. So a part has to
/// do with few objects of many.
Share share_of(std::span<const std::uint64_t> counts, std::size_t object, const PartNumber& part);

/// Returns which of the `count` cells of an isosurface a part holds, `object` being its index in
/// Scene::objects. Each isosurface is shared out over all parts, which differ by one cell at most;
/// each begins with another part.
Share share_of_cells(std::uint64_t count, std::size_t object, const PartNumber& part);

/// Cuts an object down to a share: of triangles, with the vertices that they need; of points; of
/// lines, whole, since a ribbon's segment hangs on its neighbours, and a tube is one solid. Scalars
/// are dropped: colours have been made of them. An isosurface stays as it is, and whoever crosses
/// it chooses among its cells by share_of_cells(). Returns the number that the object's first
/// primitive (see Scene) has in the whole object.
std::uint32_t cut_object(SceneObject& object, const Share& share);

}  // namespace pellucid::scene
