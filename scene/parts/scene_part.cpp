// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/parts/scene_part.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>

namespace pellucid::scene {
namespace {

/// The elements `share` of an array that has one for each vertex, or none.
template <class T>
void keep(std::vector<T>& values, const Share& share) {
  if (values.empty()) return;
  values = std::vector<T>(values.begin() + std::ptrdiff_t(share.begin),
                          values.begin() + std::ptrdiff_t(share.end));
}

Radii kept(const Radii& radii, const Share& share) {
  if (!radii.vary()) return radii;
  std::vector<double> some;
  for (std::uint64_t i = share.begin; i < share.end; ++i) some.push_back(radii.at(i));
  return Radii(std::move(some));
}

void keep(geometry::Vertices& vertices, const Share& share) {
  keep(vertices.positions, share);
  keep(vertices.normals, share);
  keep(vertices.colors, share);
  keep(vertices.importance, share);
  vertices.scalars.clear();
}

/// The values at these places, in their order.
template <class T>
void gather(std::vector<T>& values, const std::vector<std::uint32_t>& places) {
  if (values.empty()) return;
  std::vector<T> some;
  some.reserve(places.size());
  for (const std::uint32_t place : places) some.push_back(values[place]);
  values = std::move(some);
}

/// Renumbers the vertices in the order in which the triangles name them; returns which they were.
std::vector<std::uint32_t> renumber(std::vector<std::array<std::uint32_t, 3>>& triangles,
                                    std::size_t vertex_count) {
  constexpr std::uint32_t unnamed = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> named, number(vertex_count, unnamed);
  for (auto& triangle : triangles)
    for (std::uint32_t& vertex : triangle) {
      if (number[vertex] == unnamed) {
        number[vertex] = std::uint32_t(named.size());
        named.push_back(vertex);
      }
      vertex = number[vertex];
    }
  return named;
}

/// The i-th piece, from 0, of as many as there are parts.
Share piece_of(std::uint64_t count, std::uint64_t i, const PartNumber& part) {
  assert(1 <= part.part && part.part <= part.count && part.count <= most_parts);
  const std::uint64_t n = std::uint64_t(part.count);
  // count * i would not fit for a count beyond 2^48: whole rounds first.
  const auto until = [&](std::uint64_t k) { return count / n * k + count % n * k / n; };
  return {until(i), until(i + 1)};
}

struct Cutter {
  const Share& share;

  std::uint32_t operator()(geometry::TriangleMesh& mesh) const {
    keep(mesh.triangles, share);
    const std::vector<std::uint32_t> named = renumber(mesh.triangles, mesh.positions.size());
    gather(mesh.positions, named);
    gather(mesh.normals, named);
    gather(mesh.colors, named);
    gather(mesh.importance, named);
    mesh.scalars.clear();
    mesh.face_scalars.clear();
    return std::uint32_t(share.begin);
  }

  std::uint32_t operator()(PointObject& points) const {
    keep(points.set, share);
    points.radius = kept(points.radius, share);
    return std::uint32_t(share.begin);
  }

  std::uint32_t operator()(LineObject& lines) const {
    geometry::LineSet& set = lines.set;
    geometry::LineSet before;
    before.offsets.assign(set.offsets.begin(),
                          set.offsets.begin() + std::ptrdiff_t(share.begin) + 1);
    const std::uint64_t first = set.offsets[share.begin];
    const Share points{first, set.offsets[share.end]};
    keep(set, points);
    lines.radius = kept(lines.radius, points);
    keep(set.offsets, Share{share.begin, share.end + 1});
    for (std::uint64_t& offset : set.offsets) offset -= first;
    const bool is_ribbon = lines.profile == LineObject::Profile::ribbon;
    return std::uint32_t((is_ribbon ? 2 : 1) * before.segment_count());
  }

  std::uint32_t operator()(Isosurface&) const { return 0; }
};

}  // namespace

std::uint64_t shared_elements(const SceneObject& object, PartOf of) {
  if (object.opaque && of == PartOf::transparent_objects) return 0;
  if (const auto* mesh = std::get_if<geometry::TriangleMesh>(&object.shape))
    return mesh->triangles.size();
  if (const auto* points = std::get_if<PointObject>(&object.shape))
    return points->set.positions.size();
  if (const auto* lines = std::get_if<LineObject>(&object.shape)) return lines->set.line_count();
  return 0;
}

Share share_of(std::span<const std::uint64_t> counts, std::size_t object, const PartNumber& part) {
  assert(object < counts.size());
  const auto before =
      std::accumulate(counts.begin(), counts.begin() + std::ptrdiff_t(object), std::uint64_t(0));
  const Share piece = piece_of(std::accumulate(counts.begin(), counts.end(), std::uint64_t(0)),
                               std::uint64_t(part.part) - 1, part);
  const auto within = [&](std::uint64_t place) {
    return std::clamp(place, before, before + counts[object]) - before;
  };
  return {within(piece.begin), within(piece.end)};
}

Share share_of_cells(std::uint64_t count, std::size_t object, const PartNumber& part) {
  return piece_of(count, (std::uint64_t(part.part) - 1 + object) % std::uint64_t(part.count), part);
}

std::uint32_t cut_object(SceneObject& object, const Share& share) {
  return std::visit(Cutter{share}, object.shape);
}

}  // namespace pellucid::scene
