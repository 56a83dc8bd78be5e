#include "groundtruth/crossing_geometry.h"

#include "core/error.h"
#include "groundtruth/ribbon_geometry.h"
#include "groundtruth/triangle_geometry.h"

namespace pellucid {
namespace {

struct Maker {
  std::uint32_t index;
  const GeometryContext& context;

  std::unique_ptr<CrossingGeometry> operator()(const TriangleMesh& mesh) const {
    return std::make_unique<TriangleGeometry>(mesh, index, context);
  }
  std::unique_ptr<CrossingGeometry> operator()(const LineObject& lines) const {
    if (lines.profile == LineObject::Profile::tube)
      throw InputError("raytrace: tubes; accepted: meshes and ribbons");
    return std::make_unique<RibbonGeometry>(lines, index, context);
  }
  std::unique_ptr<CrossingGeometry> operator()(const PointObject&) const {
    throw InputError("raytrace: points; accepted: meshes and ribbons");
  }
};

}  // namespace

std::unique_ptr<CrossingGeometry> make_geometry(const SceneObject& object, std::uint32_t index,
                                                const GeometryContext& context) {
  return std::visit(Maker{index, context}, object.shape);
}

}  // namespace pellucid
