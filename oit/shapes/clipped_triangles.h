// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "oit/shapes/batch.h"
#include "oit/shapes/guard_band.h"

namespace pellucid::oit {

/// An IndexTriangle holds three indices of vertices, from 0.
using IndexTriangle = std::array<std::uint32_t, 3>;

/// A Corner is a corner of a triangle with all that is uploaded of it.
struct Corner {
  Vec3 world{0};
  Rgba color{0};
  Vec3 direction{0};  // of a lit scene: a mesh's normal, a line's direction; world
  double across = 0;  // a ribbon: -1 at one rim, 1 at the other
  float importance = 0;
  std::uint32_t vertex = 0;  // among those of its kind
};

/// A ClippedVertex is a corner of a part of a triangle.
struct ClippedVertex {
  glm::vec3 position{0};  // see ViewSpace
  glm::vec4 color{0};
  Vec3 direction{0};  // as a Corner's
  float across = 0, importance = 0;
  std::array<std::uint32_t, 3> corners{};  // of the triangle
  Vec3 weights{0};                         // of these
};

/// ClippedTriangles are the parts of those triangles that reach beyond the guard band.
struct ClippedTriangles {
  /// A Cut says which triangle of its kind it is, and which triangles are its parts.
  struct Cut {
    std::uint32_t triangle, first, count;  // first, count: of `parts`; none: it is not seen
  };

  std::vector<ClippedVertex> vertices;
  std::vector<IndexTriangle> parts;  // indices go on from the vertices of the kind
  std::vector<Cut> cuts;             // ascending

  /// Returns the value of a clipped vertex, of a value that every vertex of the kind has.
  template <class ValueOf>
  static float interpolate(const ClippedVertex& vertex, const ValueOf& value_of) {
    double sum = 0;
    for (int i = 0; i < 3; ++i)
      sum += vertex.weights[i] * double(value_of(vertex.corners[std::size_t(i)]));
    return float(sum);
  }
};

/// A TriangleClipper collects ClippedTriangles, in double, before anything is rounded to float.
class TriangleClipper {
 public:
  /// `vertices` is the number of vertices of the kind.
  TriangleClipper(const ViewSpace& view, std::uint32_t vertices)
      : view_(view), band_(view), vertices_(vertices) {}

  /// Says whether a point of the world lies within the guard band.
  bool holds(const Vec3& world) const { return band_.holds(view_.exact_position(world)); }
  /// Cuts off a triangle, one of whose corners does not. Triangles come in ascending order. Throws
  /// InputError, after `object`, for corners that are too far away for double.
  void clip(std::uint32_t triangle, const std::array<Corner, 3>& corners,
            const std::string& object);
  ClippedTriangles take() { return std::move(clipped_); }

 private:
  const ViewSpace& view_;
  GuardBand band_;
  std::uint32_t vertices_;
  ClippedTriangles clipped_;
  std::vector<ClippedCorner> part_;
};

/// Returns the batches with those of the kind cut up, so that the parts of a triangle are drawn in
/// its place, as it. They lie behind the `triangles` of the kind.
std::vector<Batch> with_parts(const std::vector<Batch>& batches, ShapeKind kind,
                              const std::vector<ClippedTriangles::Cut>& cuts,
                              std::uint32_t triangles);

}  // namespace pellucid::oit
