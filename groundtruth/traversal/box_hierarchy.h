// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "groundtruth/shapes/triangle_geometry.h"
#include "groundtruth/traversal/packet_traversal.h"

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

  /// Says whether the boxes will stay where they are, or move, as a turning scene's do.
  enum class Motion { still, moving };

  /// Builds the hierarchy with its origin at `center`, in view coordinates. Throws WorkError when
  /// Embree fails.
  BoxHierarchy(std::vector<Object> objects, const Vec3& center, const Callbacks& callbacks,
               Motion motion = Motion::still);
  BoxHierarchy(const BoxHierarchy&) = delete;
  BoxHierarchy& operator=(const BoxHierarchy&) = delete;

  /// Takes other boxes, as many of each object as it has, and keeps its tree, which only grows
  /// larger boxes: far less work than building one. Returns false, and does nothing, where it has
  /// another number of objects or boxes, or was not made for moving ones. Throws WorkError when
  /// Embree fails.
  bool move(std::vector<Object>& objects, const Vec3& center);

  /// Lets the packet's valid rays meet the boxes: the callbacks are called, `decide` or
  /// `decide_and_close`. See PacketTraversal.
  ///@{
  void decide(const int* valid, EmbreeContext& context, RTCRay16& rays) const {
    traversal_.occluded(valid, scene_.get(), context, rays);
  }
  void decide_and_close(const int* valid, EmbreeContext& context, RTCRayHit16& rays) const {
    traversal_.intersect(valid, scene_.get(), context, rays);
  }
  ///@}

  const Vec3& center() const { return center_; }                   // view coordinates
  const std::vector<Object>& objects() const { return objects_; }  // as Scene::objects
  std::uint64_t bytes() const;                                     // with what the geometries keep

 private:
  /// Gives back what Embree has made, also when building ends early.
  struct Release {
    void operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
    void operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
    void operator()(RTCGeometryTy* geometry) const { rtcReleaseGeometry(geometry); }
  };
  using Geometry = std::unique_ptr<RTCGeometryTy, Release>;

  void keep_trees();
  void commit();
  Geometry boxes(const Object& object, const Callbacks& callbacks) const;
  Geometry triangles(const TriangleGeometry& mesh, RTCFilterFunctionN filter) const;
  bool has_as_many_boxes(const std::vector<Object>& objects) const;

  Motion motion_;
  Vec3 center_;
  std::vector<Object> objects_;
  std::atomic<std::int64_t> embree_bytes_ = 0;
  std::unique_ptr<RTCDeviceTy, Release> device_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
  PacketTraversal traversal_;
};

}  // namespace pellucid::groundtruth
