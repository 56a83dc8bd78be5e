// SPDX-License-Identifier: GPL-3.0-or-later
#include "oit/shapes/clipped_triangles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace pellucid::oit {
namespace {

// Products of three coordinates are numbers yet.
constexpr double farthest = 1e100;  // view units

void check(const Vec3& position, const std::string& object) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(position[axis]) < farthest))
      throw InputError(
          fmt::format("{}: a corner lies over 1e100 times farther away than the scene is deep; "
                      "accepted by this "
                      "method: less; raytrace draws it",
                      object));
}

ClippedVertex vertex_of(const ClippedCorner& corner, const std::array<Corner, 3>& corners) {
  ClippedVertex vertex;
  vertex.position = glm::vec3(corner.position);
  vertex.weights = corner.weights;
  glm::dvec4 color(0);
  double importance = 0, across = 0;
  for (int i = 0; i < 3; ++i) {
    const double weight = corner.weights[i];
    const Corner& from = corners[std::size_t(i)];
    color += weight * glm::dvec4(from.color);
    vertex.direction += weight * from.direction;
    across += weight * from.across;
    importance += weight * double(from.importance);
    vertex.corners[std::size_t(i)] = from.vertex;
  }
  vertex.color = glm::vec4(color);
  vertex.across = float(across);
  vertex.importance = float(importance);
  return vertex;
}

/// The triangles from `first` up to `last` of a batch.
Batch stretch(const Batch& batch, std::uint32_t first, std::uint32_t last) {
  Batch part = batch;
  const std::uint32_t skipped = first - batch.first;
  part.first_primitive = std::min(batch.first_primitive + skipped, batch.last_primitive);
  part.first_of_kind += skipped;
  part.first = first;
  part.count = last - first;
  return part;
}

Batch parts_of(const Batch& batch, const ClippedTriangles::Cut& cut, std::uint32_t triangles) {
  Batch parts = stretch(batch, cut.triangle, cut.triangle + 1);
  parts.last_primitive = parts.first_primitive;
  parts.last_of_kind = parts.first_of_kind;
  parts.first = triangles + cut.first;
  parts.count = cut.count;
  return parts;
}

}  // namespace

void TriangleClipper::clip(std::uint32_t triangle, const std::array<Corner, 3>& corners,
                           const std::string& object) {
  std::array<Vec3, 3> positions;
  for (std::size_t i = 0; i < 3; ++i) {
    positions[i] = view_.exact_position(corners[i].world);
    check(positions[i], object);
  }
  band_.clip(positions, part_);
  const auto first = std::uint32_t(clipped_.parts.size());
  const auto base = vertices_ + std::uint32_t(clipped_.vertices.size());
  for (const ClippedCorner& corner : part_) clipped_.vertices.push_back(vertex_of(corner, corners));
  for (std::uint32_t i = 2; i < part_.size(); ++i)
    clipped_.parts.push_back({base, base + i - 1, base + i});
  clipped_.cuts.push_back({triangle, first, std::uint32_t(clipped_.parts.size()) - first});
}

std::vector<Batch> with_parts(const std::vector<Batch>& batches, ShapeKind kind,
                              const std::vector<ClippedTriangles::Cut>& cuts,
                              std::uint32_t triangles) {
  std::vector<Batch> result;
  auto cut = cuts.begin();
  for (const Batch& batch : batches) {
    std::uint32_t first = batch.first;
    const std::uint32_t end = batch.first + batch.count;
    for (; batch.kind == kind && cut != cuts.end() && cut->triangle < end; ++cut) {
      if (cut->count == 0) continue;  // without area where it was
      if (first < cut->triangle) result.push_back(stretch(batch, first, cut->triangle));
      result.push_back(parts_of(batch, *cut, triangles));
      first = cut->triangle + 1;
    }
    if (first < end) result.push_back(stretch(batch, first, end));
  }
  return result;
}

}  // namespace pellucid::oit
