#include "groundtruth/crossing_finder.h"

#include <algorithm>
#include <cmath>

#include "groundtruth/box_hierarchy.h"
#include "groundtruth/crossing_order.h"
#include "groundtruth/solid_union.h"

namespace pellucid {
namespace {

/// The scene lies within √3 of its centre: a ray is traversed within this distance of its point
/// that is nearest to the centre.
constexpr double reach = 1.75;
/// A ray starts this far behind the eye, so that rounding hides nothing directly in front of it;
/// what lies behind is sorted out in double.
constexpr double behind_eye = 1e-3;

constexpr std::size_t width = RayPacket::width;

/// What the callback needs of the rays; Embree hands the context through.
struct PacketContext {
  RTCIntersectContext embree;
  RayPacket rays;
};

/// Decides the candidates of a box, and never reports a hit to Embree, so that the traversal goes
/// on.
void decide(const RTCOccludedFunctionNArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const PacketContext& context = *reinterpret_cast<const PacketContext*>(args->context);
  std::uint32_t lanes = 0;
  for (unsigned i = 0; i < args->N; ++i)
    if (args->valid[i]) lanes |= 1u << RTCRayN_id(args->ray, args->N, i);
  object.geometry->cross(args->primID, context.rays, lanes);
}

/// Takes every hit of a mesh as it is, and rejects it, so that the traversal goes on.
void take(const RTCFilterFunctionNArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const auto& mesh = static_cast<const TriangleGeometry&>(*object.geometry);
  const PacketContext& context = *reinterpret_cast<const PacketContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    args->valid[i] = 0;
    const unsigned lane = RTCRayN_id(args->ray, args->N, i);
    context.rays.crossings[lane]->push_back(mesh.crossing_at(RTCHitN_primID(args->hit, args->N, i),
                                                             RTCHitN_u(args->hit, args->N, i),
                                                             RTCHitN_v(args->hit, args->N, i)));
  }
}

BoxHierarchy::Callbacks callbacks(Precision precision) {
  return {decide, precision == Precision::fast ? take : nullptr};
}

std::vector<BoxHierarchy::Object> make_objects(const Scene& scene, const ViewFrame& frame,
                                               const std::optional<MarchOptions>& march) {
  const GeometryContext context{frame, scene.camera, scene.lighting, march};
  std::vector<BoxHierarchy::Object> objects;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    objects.push_back({make_geometry(scene.objects[i], i, context), scene.objects[i].opaque});
  return objects;
}

}  // namespace

struct CrossingFinder::State {
  ViewFrame frame;
  Precision precision;
  BoxHierarchy hierarchy;
  double largest = 0;  // coordinate
  bool any_union = false, any_opaque = false;

  State(const Scene& scene, Precision precision_, const std::optional<MarchOptions>& march)
      : frame(scene),
        precision(precision_),
        hierarchy(make_objects(scene, frame, march), frame.from_world(scene.bounds().center()),
                  callbacks(precision_)) {
    for (const BoxHierarchy::Object& object : hierarchy.objects()) {
      largest = std::max(largest, object.geometry->largest_coordinate());
      any_union |= object.geometry->is_union();
      any_opaque |= object.opaque;
    }
  }

  void prepare(const PictureRay& ray, std::vector<Crossing>& crossings, std::size_t lane,
               PacketContext& context, RTCRay8& traversal) const;
  void finish(std::vector<Crossing>& crossings) const;
  void unite(std::vector<Crossing>& crossings) const;
};

/// Leaves of the crossings with unions those with their surfaces.
void CrossingFinder::State::unite(std::vector<Crossing>& crossings) const {
  std::vector<PartCrossing> parts;
  std::erase_if(crossings, [&](const Crossing& crossing) {
    const CrossingGeometry& geometry = *hierarchy.objects()[crossing.object].geometry;
    if (geometry.is_union()) parts.push_back({geometry.solid(crossing), crossing});
    return geometry.is_union();
  });
  append_union(parts, crossings);
}

CrossingFinder::CrossingFinder(const Scene& scene, Precision precision,
                               const std::optional<MarchOptions>& march)
    : state_(std::make_unique<State>(scene, precision, march)) {}

CrossingFinder::~CrossingFinder() = default;

const ViewFrame& CrossingFinder::frame() const { return state_->frame; }

void CrossingFinder::State::prepare(const PictureRay& ray, std::vector<Crossing>& crossings,
                                    std::size_t lane, PacketContext& context,
                                    RTCRay8& traversal) const {
  crossings.clear();
  const bool perspective = ray.projection == Projection::perspective;
  const Vec3 direction = perspective ? glm::normalize(Vec3(ray.x, ray.y, 1)) : Vec3(0, 0, 1);
  const Vec3 eye_point = perspective ? Vec3(0) : Vec3(ray.x, ray.y, 0);
  const Vec3 start = eye_point - hierarchy.center();
  const double nearest = -glm::dot(start, direction);
  const double begin = std::max(nearest - reach, -behind_eye), end = nearest + reach;
  const Vec3 origin = start + begin * direction;
  context.rays.rays.push_back({ray, {ray, largest, precision}, eye_point, direction});
  context.rays.test.set(lane, context.rays.rays.back().test);
  context.rays.crossings[lane] = &crossings;
  traversal.org_x[lane] = float(origin.x);
  traversal.org_y[lane] = float(origin.y);
  traversal.org_z[lane] = float(origin.z);
  traversal.dir_x[lane] = float(direction.x);
  traversal.dir_y[lane] = float(direction.y);
  traversal.dir_z[lane] = float(direction.z);
  traversal.tfar[lane] = float(end - begin);  // negative: the ray has nothing in front of the eye
  traversal.mask[lane] = ~0u;
  traversal.id[lane] = unsigned(lane);
}

/// Orders the crossings of a traversal and drops those that are not the ray's.
void CrossingFinder::State::finish(std::vector<Crossing>& crossings) const {
  if (any_union) unite(crossings);
  std::erase_if(crossings, [](const Crossing& c) { return !(c.depth > 0); });
  order_crossings(crossings);
  if (!any_opaque) return;
  const auto opaque = [this](const Crossing& c) { return hierarchy.objects()[c.object].opaque; };
  const auto end_of_ray = std::find_if(crossings.begin(), crossings.end(), opaque);
  if (end_of_ray != crossings.end()) crossings.erase(end_of_ray + 1, crossings.end());
}

void CrossingFinder::find(const PictureRay& ray, std::vector<Crossing>& crossings) const {
  find({&ray, 1}, {&crossings, 1});
}

void CrossingFinder::find(std::span<const PictureRay> rays,
                          std::span<std::vector<Crossing>> crossings) const {
  PacketContext context{};
  rtcInitIntersectContext(&context.embree);
  // Not as coherent rays: Embree 3.13.5 then brings a candidate twice to rays of which a component
  // of the direction is 0.
  context.rays.rays.reserve(width);  // the packet's test points into it
  RTCRay8 traversal{};
  alignas(32) int valid[width] = {};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    state_->prepare(rays[i], crossings[i], i, context, traversal);
    valid[i] = traversal.tfar[i] >= 0 ? -1 : 0;
  }
  rtcOccluded8(valid, state_->hierarchy.scene(), &context.embree, &traversal);
  for (std::size_t i = 0; i < rays.size(); ++i) state_->finish(crossings[i]);
}

Fragment CrossingFinder::shade(const Crossing& crossing, const Vec3& world_direction) const {
  const BoxHierarchy::Object& object = state_->hierarchy.objects()[crossing.object];
  Fragment fragment = object.geometry->shade(crossing, world_direction);
  if (object.opaque) fragment.opacity = 1;
  return fragment;
}

double CrossingFinder::importance(const Crossing& crossing) const {
  return state_->hierarchy.objects()[crossing.object].geometry->importance(crossing);
}

std::uint64_t CrossingFinder::bytes() const { return state_->hierarchy.bytes(); }

}  // namespace pellucid
