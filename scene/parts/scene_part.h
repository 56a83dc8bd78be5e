// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Parts of a scene's primitives, so that each may be drawn by itself and their crossings merged.

#include <cstddef>
#include <cstdint>

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

/// Returns which of the `count` elements of an object a part holds, `object` being its index in
/// Scene::objects. The shares of all parts follow each other, have no element in common, and leave
/// none out; they differ by one element at most. Each object begins with another part, so that
/// objects of few elements are spread over the parts.
Share share_of(std::uint64_t count, std::size_t object, const PartNumber& part);

/// Cuts an object down to its share: of triangles, with the vertices that they need; of points; of
/// lines, whole, since a ribbon's segment hangs on its neighbours, and a tube is one solid. Scalars
/// are dropped: colours have been made of them. An isosurface stays as it is, and whoever crosses
/// it chooses among its cells by share_of(). Returns the number that the object's first primitive
/// (see Scene) has in the whole object.
std::uint32_t cut_object(SceneObject& object, std::size_t index, const PartNumber& part);

}  // namespace pellucid::scene
