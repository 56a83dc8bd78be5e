#include "groundtruth/crossing_finder.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "groundtruth/crossing_geometry.h"
#include "groundtruth/solid_union.h"

namespace pellucid {
namespace {

/// Boxes grow by this much on every side, in units. A traversal starts at most 3.5 units before the
/// end of the scene, so rounding to float moves a point of the ray by at most half an ulp of 4 for
/// its origin (2.4e-7) plus 4 · 2^-25 for its direction (1.2e-7), and a box by 6e-8.
constexpr float box_margin = 0x1p-20f;  // 9.5e-7

/// The scene lies within √3 of its centre: a ray is traversed within this distance of its point
/// that is nearest to the centre.
constexpr double reach = 1.75;
/// A ray starts this far behind the eye, so that rounding hides nothing directly in front of it;
/// what lies behind is sorted out in double.
constexpr double behind_eye = 1e-3;

/// Embree's handle on a geometry.
struct Attachment {
  std::unique_ptr<CrossingGeometry> geometry;
  bool opaque;
  const Vec3* center;  // of the scene: Embree's origin, so that its floats are as fine as can be
};

/// What the callback needs of the ray; Embree hands the context through.
struct RayContext {
  RTCIntersectContext embree;
  const SceneRay* ray;
  std::vector<Crossing>* crossings;
};

void give_box(const RTCBoundsFunctionArguments* args) {
  const Attachment& attachment = *static_cast<const Attachment*>(args->geometryUserPtr);
  const Box3 box = attachment.geometry->box(args->primID);
  const Vec3 low = box.min - *attachment.center, high = box.max - *attachment.center;
  RTCBounds& out = *args->bounds_o;
  out.lower_x = float(low.x) - box_margin;
  out.lower_y = float(low.y) - box_margin;
  out.lower_z = float(low.z) - box_margin;
  out.upper_x = float(high.x) + box_margin;
  out.upper_y = float(high.y) + box_margin;
  out.upper_z = float(high.z) + box_margin;
}

/// Decides the candidates of a box, and never reports a hit to Embree, so that the traversal goes
/// on.
void test_box(const RTCOccludedFunctionNArguments* args) {
  const Attachment& attachment = *static_cast<const Attachment*>(args->geometryUserPtr);
  const RayContext& context = *reinterpret_cast<const RayContext*>(args->context);
  attachment.geometry->cross(args->primID, *context.ray, *context.crossings);
}

/// Leaves of the crossings with unions those with their surfaces.
void unite(const std::vector<Attachment>& attachments, std::vector<Crossing>& crossings) {
  std::vector<PartCrossing> parts;
  std::erase_if(crossings, [&](const Crossing& crossing) {
    const CrossingGeometry& geometry = *attachments[crossing.object].geometry;
    if (geometry.is_union()) parts.push_back({geometry.solid(crossing), crossing});
    return geometry.is_union();
  });
  append_union(parts, crossings);
}

void throw_embree_error(void*, RTCError code, const char* text) {
  throw WorkError(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

bool count_memory(void* counter, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::int64_t>*>(counter) += bytes;
  return true;
}

}  // namespace

struct CrossingFinder::State {
  ViewFrame frame;
  Precision precision;
  Vec3 center;  // of the scene, view coordinates
  bool any_union = false;
  double largest = 0;                   // coordinate
  std::vector<Attachment> attachments;  // as Scene::objects
  std::atomic<std::int64_t> embree_bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  State(const Scene& from, Precision precision_)
      : frame(from), precision(precision_), center(frame.from_world(from.bounds().center())) {
    const GeometryContext context{frame, from.camera, from.lighting};
    attachments.reserve(from.objects.size());
    for (const SceneObject& object : from.objects) {
      const auto index = static_cast<std::uint32_t>(attachments.size());
      attachments.push_back({make_geometry(object, index, context), object.opaque, &center});
      largest = std::max(largest, attachments.back().geometry->largest_coordinate());
      any_union |= attachments.back().geometry->is_union();
    }
    build();
  }

  void build() {
    device = rtcNewDevice(nullptr);
    if (!device) throw WorkError("Embree cannot start on this machine");
    rtcSetDeviceErrorFunction(device, throw_embree_error, nullptr);
    rtcSetDeviceMemoryMonitorFunction(device, count_memory, &embree_bytes);
    scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    for (Attachment& attachment : attachments) {
      RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, attachment.geometry->box_count());
      rtcSetGeometryUserData(geometry, &attachment);
      rtcSetGeometryBoundsFunction(geometry, give_box, nullptr);
      rtcSetGeometryOccludedFunction(geometry, test_box);
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene);
  }

  ~State() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

CrossingFinder::CrossingFinder(const Scene& scene, Precision precision)
    : state_(std::make_unique<State>(scene, precision)) {}

CrossingFinder::~CrossingFinder() = default;

const ViewFrame& CrossingFinder::frame() const { return state_->frame; }

void CrossingFinder::find(const PictureRay& ray, std::vector<Crossing>& crossings) const {
  crossings.clear();
  const bool perspective = ray.projection == Projection::perspective;
  const Vec3 direction = perspective ? glm::normalize(Vec3(ray.x, ray.y, 1)) : Vec3(0, 0, 1);
  const Vec3 eye_point = perspective ? Vec3(0) : Vec3(ray.x, ray.y, 0);
  const Vec3 start = eye_point - state_->center;
  const double nearest = -glm::dot(start, direction);
  const double begin = std::max(nearest - reach, -behind_eye), end = nearest + reach;
  if (end < begin) return;
  const Vec3 origin = start + begin * direction;

  const SceneRay scene_ray{ray, {ray, state_->largest, state_->precision}, eye_point, direction};
  RayContext context{{}, &scene_ray, &crossings};
  rtcInitIntersectContext(&context.embree);
  RTCRay traversal{};
  traversal.org_x = float(origin.x);
  traversal.org_y = float(origin.y);
  traversal.org_z = float(origin.z);
  traversal.dir_x = float(direction.x);
  traversal.dir_y = float(direction.y);
  traversal.dir_z = float(direction.z);
  traversal.tfar = float(end - begin);
  traversal.mask = ~0u;
  rtcOccluded1(state_->scene, &context.embree, &traversal);
  if (state_->any_union) unite(state_->attachments, crossings);
  std::erase_if(crossings, [](const Crossing& c) { return !(c.depth > 0); });
  std::sort(crossings.begin(), crossings.end());
  const auto opaque = [this](const Crossing& c) { return state_->attachments[c.object].opaque; };
  const auto end_of_ray = std::find_if(crossings.begin(), crossings.end(), opaque);
  if (end_of_ray != crossings.end()) crossings.erase(end_of_ray + 1, crossings.end());
}

Fragment CrossingFinder::shade(const Crossing& crossing, const Vec3& world_direction) const {
  const Attachment& attachment = state_->attachments[crossing.object];
  Fragment fragment = attachment.geometry->shade(crossing, world_direction);
  if (attachment.opaque) fragment.opacity = 1;
  return fragment;
}

double CrossingFinder::importance(const Crossing& crossing) const {
  return state_->attachments[crossing.object].geometry->importance(crossing);
}

std::uint64_t CrossingFinder::bytes() const {
  std::uint64_t sum = static_cast<std::uint64_t>(state_->embree_bytes);
  for (const Attachment& attachment : state_->attachments) sum += attachment.geometry->bytes();
  return sum;
}

}  // namespace pellucid
