// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/shapes/crossing_geometry.h"

#include <fmt/format.h>

#include <bit>

#include "core/error.h"
#include "groundtruth/shapes/disc_geometry.h"
#include "groundtruth/shapes/exact_isosurface.h"
#include "groundtruth/shapes/marched_isosurface.h"
#include "groundtruth/shapes/ribbon_geometry.h"
#include "groundtruth/shapes/sphere_geometry.h"
#include "groundtruth/shapes/triangle_geometry.h"
#include "groundtruth/shapes/tube_geometry.h"

namespace pellucid::groundtruth {
namespace {

struct Maker {
  bool opaque;
  std::uint32_t index;
  const GeometryContext& context;
  const CrossingGeometry* before;

  std::unique_ptr<CrossingGeometry> operator()(const geometry::TriangleMesh& mesh) const {
    return std::make_unique<TriangleGeometry>(mesh, index, context,
                                              dynamic_cast<const TriangleGeometry*>(before));
  }
  std::unique_ptr<CrossingGeometry> operator()(const scene::LineObject& lines) const {
    if (lines.profile == scene::LineObject::Profile::tube)
      return std::make_unique<TubeGeometry>(lines, index, context,
                                            dynamic_cast<const TubeGeometry*>(before));
    return std::make_unique<RibbonGeometry>(lines, index, context,
                                            dynamic_cast<const RibbonGeometry*>(before));
  }
  std::unique_ptr<CrossingGeometry> operator()(const scene::PointObject& points) const {
    const auto* points_before = dynamic_cast<const PointGeometry*>(before);
    if (points.profile == scene::PointObject::Profile::sphere)
      return std::make_unique<SphereGeometry>(points, index, context, points_before);
    return std::make_unique<DiscGeometry>(points, index, context, points_before);
  }
  std::unique_ptr<CrossingGeometry> operator()(const scene::Isosurface& surface) const {
    if (context.march)
      return std::make_unique<MarchedIsosurface>(surface, opaque, index, context, *context.march);
    return std::make_unique<ExactIsosurface>(surface, index, context);
  }
};

}  // namespace

void check_count(std::size_t count, const char* what) {
  if (count >> 32) throw InputError(fmt::format("{} {}; accepted: fewer than 2^32", count, what));
}

void RayByRayGeometry::cross(std::uint32_t k, const RayPacket& packet, std::uint32_t lanes) const {
  for (; lanes != 0; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    cross(k, packet.rays[i], *packet.crossings[i]);
  }
}

std::unique_ptr<CrossingGeometry> make_geometry(const scene::SceneObject& object,
                                                std::uint32_t index, const GeometryContext& context,
                                                const CrossingGeometry* before) {
  GeometryContext of_object = context;
  of_object.lighting = object.lighting.value_or(context.lighting);
  return std::visit(Maker{object.opaque, index, of_object, before}, object.shape);
}

}  // namespace pellucid::groundtruth
