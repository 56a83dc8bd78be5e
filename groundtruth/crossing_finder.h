#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "groundtruth/exact_sign.h"
#include "scene/scene.h"
#include "scene/unit_frame.h"

namespace pellucid {

/// Where a ray crosses a triangle in front of the eye.
struct Crossing {
  double depth;            // view depth, unit lengths (see UnitFrame)
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

/// Finds every crossing of a ray with a scene. Embree's traversal brings the candidates: each
/// triangle is a user primitive whose box is widened by more than the rounding of rays and boxes to
/// float, so none is missed; crosses() decides each. Thread-safe once it is made.
class CrossingFinder {
 public:
  CrossingFinder(const Scene& scene, Precision precision);
  ~CrossingFinder();

  /// All crossings of the ray through a picture point (pixels; centres at +0.5), front to back.
  /// `crossings` is overwritten; its capacity is reused.
  void find(double x, double y, std::vector<Crossing>& crossings) const;

  PictureRay ray(double x, double y) const;  // in the unit frame
  std::uint64_t bytes() const;               // of the hierarchy and of the vertex copies

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pellucid
