#include "groundtruth/box_hierarchy.h"

#include <fmt/format.h>

#include "core/error.h"

namespace pellucid {
namespace {

void give_box(const RTCBoundsFunctionArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const Box3 box = object.geometry->box(args->primID);
  const Vec3 low = box.min - object.center, high = box.max - object.center;
  RTCBounds& out = *args->bounds_o;
  out.lower_x = float(low.x) - BoxHierarchy::margin;
  out.lower_y = float(low.y) - BoxHierarchy::margin;
  out.lower_z = float(low.z) - BoxHierarchy::margin;
  out.upper_x = float(high.x) + BoxHierarchy::margin;
  out.upper_y = float(high.y) + BoxHierarchy::margin;
  out.upper_z = float(high.z) + BoxHierarchy::margin;
}

void throw_embree_error(void*, RTCError code, const char* text) {
  throw WorkError(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

bool count_memory(void* counter, ssize_t bytes, bool) {
  *static_cast<std::atomic<std::int64_t>*>(counter) += bytes;
  return true;
}

}  // namespace

BoxHierarchy::BoxHierarchy(std::vector<Object> objects, const Vec3& center,
                           RTCOccludedFunctionN decide)
    : center_(center), objects_(std::move(objects)), device_(rtcNewDevice(nullptr)) {
  if (!device_) throw WorkError("Embree cannot start on this machine");
  rtcSetDeviceErrorFunction(device_, throw_embree_error, nullptr);
  rtcSetDeviceMemoryMonitorFunction(device_, count_memory, &embree_bytes_);
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  for (Object& object : objects_) {
    object.center = center;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, object.geometry->box_count());
    rtcSetGeometryUserData(geometry, &object);
    rtcSetGeometryBoundsFunction(geometry, give_box, nullptr);
    rtcSetGeometryOccludedFunction(geometry, decide);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(scene_);
}

BoxHierarchy::~BoxHierarchy() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

std::uint64_t BoxHierarchy::bytes() const {
  std::uint64_t sum = static_cast<std::uint64_t>(embree_bytes_.load());
  for (const Object& object : objects_) sum += object.geometry->bytes();
  return sum;
}

}  // namespace pellucid
