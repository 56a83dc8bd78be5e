#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "groundtruth/exact_sign.h"
#include "scene/scene.h"

namespace pellucid {

/// Where a ray crosses a triangle in front of the eye.
struct Crossing {
  double depth;            // view depth, units (see ViewFrame)
  double u, v;             // weights of the triangle's second and third vertex; the first has 1-u-v
  std::uint32_t object;    // index in Scene::objects
  std::uint32_t triangle;  // index in TriangleMesh::triangles

  /// Front to back; equal depths by object, then triangle.
  friend bool operator<(const Crossing& p, const Crossing& q) {
    if (p.depth != q.depth) return p.depth < q.depth;
    if (p.object != q.object) return p.object < q.object;
    return p.triangle < q.triangle;
  }
};

/// Finds every crossing of a ray with a scene. Embree's traversal brings the candidates: one or
/// two triangles are a user primitive whose box is widened by more than the rounding of rays and
/// boxes to float, so none is missed; CrossingTest decides each. Thread-safe once it is made.
class CrossingFinder {
 public:
  CrossingFinder(const Scene& scene, Precision precision);
  ~CrossingFinder();

  const ViewFrame& frame() const;

  /// All crossings of the ray, front to back. `crossings` is overwritten; its capacity is reused.
  void find(const PictureRay& ray, std::vector<Crossing>& crossings) const;

  std::uint64_t bytes() const;  // of the hierarchy and of the vertex copies

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pellucid
