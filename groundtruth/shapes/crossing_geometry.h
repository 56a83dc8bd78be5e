// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the finder of crossings asks of a kind of geometry. A new kind is a class of this interface
// in files of its own and a line in crossing_geometry.cpp.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "groundtruth/levels/level_march.h"
#include "groundtruth/rays/crossing.h"
#include "groundtruth/rays/packet_predicate.h"
#include "groundtruth/rays/plane_depth.h"
#include "groundtruth/rays/view_frame.h"
#include "scene/parts/scene_part.h"
#include "scene/scene.h"

namespace pellucid::groundtruth {

/// A SceneRay is a ray as geometry meets it, in view coordinates.
struct SceneRay {
  PictureRay picture;
  RayPredicate predicate;  // decides crossings with flat triangles
  Vec3 start;              // the eye, or the picture's point at depth 0
  Vec3 direction;          // unit length; its z turns lengths along the ray into depths
  DepthDoubt doubt;        // depths this near to each other, or to 0, are compared as exact_depth()
};

/// A RayPacket holds up to `width` neighbouring rays that walk the hierarchy together.
struct RayPacket {
  static constexpr std::size_t width = PacketPredicate::width;

  std::vector<SceneRay> rays;
  PacketPredicate predicate;                            // of all rays
  std::array<std::vector<Crossing>*, width> crossings;  // of each ray
};

/// A packet of rays is about so wide, in units: four pixels of a picture of 1000 that shows the
/// scene, which is about 2 wide. Boxes that are smaller are mostly met by the same packets as
/// their neighbours.
constexpr double packet_width = 0.008;

/// A CrossingGeometry is one object of a scene, cut into primitives that Embree keeps in its
/// hierarchy of boxes. What the hierarchy calls a primitive may be several of the scene's, and need
/// not be crossed where its box is. It is thread-safe once it is made. All coordinates are view
/// coordinates (see ViewFrame).
class CrossingGeometry {
 public:
  virtual ~CrossingGeometry() = default;

  virtual std::uint32_t box_count() const = 0;
  /// Returns a box around everything that box `k` holds; an empty box is never visited.
  virtual Box3 box(std::uint32_t k) const = 0;
  /// Appends to their lists every crossing of the packet's rays whose bit in `lanes` is set with
  /// what box `k` holds, in any order, those behind the eye (depth ≤ 0) included or not.
  virtual void cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const = 0;

  /// Returns the depth of one of the ray's crossings, in units, free of any rounding that depends
  /// on how a shape is stored: of flat shapes the exact depth, rounded once. The depth that cross()
  /// gave is at most depth_error() away from it.
  virtual double exact_depth(const Crossing& crossing, const PictureRay&) const {
    return crossing.depth;
  }
  /// Returns a bound on the error of a crossing's depth, at most half the ray's doubt.
  virtual double depth_error(const Crossing&, const SceneRay&) const { return 0; }

  /// Returns true when several boxes may hold the same primitive, and bring the same crossing each.
  virtual bool repeats() const { return false; }
  /// Returns true when what the boxes hold are parts of solids, and only the surface of each solid
  /// counts: crossings within another part of the same solid are not the scene's (see
  /// solid_union.h).
  virtual bool is_union() const { return false; }
  /// Returns the solid that the crossing's part belongs to, where is_union().
  virtual std::uint32_t solid(const Crossing&) const { return 0; }

  /// Interpolates colour and opacity in double and lights the colour as the scene asks;
  /// `world_direction` is the ray's, of any length.
  virtual Fragment shade(const Crossing& crossing, const Vec3& world_direction) const = 0;
  /// Returns g at the crossing, in [0, 1]; 0 where the object has no importance.
  virtual double importance(const Crossing& crossing) const = 0;

  /// Returns the size of the largest coordinate of a vertex that RayPredicate is asked about.
  virtual double largest_coordinate() const = 0;
  virtual std::uint64_t bytes() const = 0;
};

/// A RayByRayGeometry meets the rays of a packet one by one.
class RayByRayGeometry : public CrossingGeometry {
 public:
  void cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const final;
  /// Does what CrossingGeometry::cross does, for one ray.
  virtual void cross(std::uint32_t k, const SceneRay& ray,
                     std::vector<Crossing>& crossings) const = 0;
};

/// A GeometryContext is what the geometries of a scene have in common. What it refers to has to
/// outlive them.
struct GeometryContext {
  const ViewFrame& frame;
  const scene::Camera& camera;
  scene::Lighting lighting;                // of objects that have none of their own
  std::optional<MarchOptions> march = {};  // isosurfaces are marched; else crossed exactly
  double stop_below = 0;  // a march ends where less than this share shows through its surface
  std::vector<scene::Isosurface::Ball> stops = {};  // where marches end: see MarchOptions::dilate
  scene::PartNumber part = {};  // which cells of isosurfaces; other shapes are cut already
};

/// Throws InputError when Crossing cannot count so many `what`: 2^32 or more.
void check_count(std::size_t count, const char* what);

/// Makes the geometry of an object, whose index in Scene::objects is `index`. The object has to
/// outlive the geometry. `before`, where it is not null, is what was made of it for another camera:
/// then boxes hold what they held there, so that their number is the same. Throws InputError for
/// more primitives than a Crossing counts.
std::unique_ptr<CrossingGeometry> make_geometry(const scene::SceneObject& object,
                                                std::uint32_t index, const GeometryContext& context,
                                                const CrossingGeometry* before = nullptr);

}  // namespace pellucid::groundtruth
