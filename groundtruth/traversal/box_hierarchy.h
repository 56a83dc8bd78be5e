// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "groundtruth/shapes/triangle_geometry.h"
#include "groundtruth/traversal/embree.h"

namespace pellucid::groundtruth {

/// A BoxHierarchy is Embree's hierarchy over the boxes of a scene's geometries. Its origin is the
/// scene's centre, so that its floats are as fine as can be, and its boxes are widened by more than
/// the rounding of rays and boxes to float, so that a traversal misses none.
class BoxHierarchy {
 public:
  /// Boxes grow by this much on every side, in units. A traversal starts at most 3.5 units before
  /// the end of the scene, so rounding to float moves a point of the ray by at most half an ulp of
  /// 4 for its origin (2.4e-7) plus 4 · 2^-25 for its direction (1.2e-7), and a box by 6e-8.
  static constexpr float margin = 0x1p-20f;  // 9.5e-7

  /// An Object is one of the scene; callbacks get it as their user pointer.
  struct Object {
    std::unique_ptr<CrossingGeometry> geometry;
    bool opaque;
    Vec3 center = {};  // the hierarchy's
  };

  /// Callbacks are what Embree calls along a traversal.
  struct Callbacks {
    RTCOccludedFunctionN decide;             // gets every candidate box
    RTCIntersectFunctionN decide_and_close;  // the same, and may shorten the ray
    RTCFilterFunctionN built_in;  // gets every hit of a mesh; null: meshes are boxes, as all else
  };

  /// Builds the hierarchy with its origin at `center`, in view coordinates. Throws WorkError when
  /// Embree fails.
  BoxHierarchy(std::vector<Object> objects, const Vec3& center, const Callbacks& callbacks);
  ~BoxHierarchy();
  BoxHierarchy(const BoxHierarchy&) = delete;
  BoxHierarchy& operator=(const BoxHierarchy&) = delete;

  RTCScene scene() const { return scene_; }
  const Vec3& center() const { return center_; }                   // view coordinates
  const std::vector<Object>& objects() const { return objects_; }  // as Scene::objects
  std::uint64_t bytes() const;                                     // with what the geometries keep

 private:
  RTCGeometry boxes(Object& object, const Callbacks& callbacks) const;
  RTCGeometry triangles(const TriangleGeometry& mesh, RTCFilterFunctionN filter) const;

  Vec3 center_;
  std::vector<Object> objects_;
  std::atomic<std::int64_t> embree_bytes_ = 0;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace pellucid::groundtruth
