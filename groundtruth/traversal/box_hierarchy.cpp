// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/box_hierarchy.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <thread>

#include "core/error.h"
#include "core/float_environment.h"
#include "core/parallel.h"

namespace pellucid::groundtruth {
namespace {

/// Embree asks for boxes from threads of its own, in libraries that the thread sanitizer does not
/// see into.
TaskFence embree_tasks;

void give_box(const RTCBoundsFunctionArguments* args) {
  embree_tasks.enter();
  const DefaultFloats floats;  // Embree flushes denormal numbers to zero while it builds
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
  embree_tasks.leave();
}

void throw_embree_error(void*, RTCError code, const char* text) {
  throw WorkError(fmt::format("Embree error {}: {}", static_cast<int>(code), text));
}

RTCDevice new_device() {
  const RTCDevice device = rtcNewDevice(nullptr);
  if (!device) throw WorkError("Embree cannot start on this machine");
  return device;
}

bool count_memory(void* counter, ssize_t bytes, bool) {
  embree_tasks.enter();
  *static_cast<std::atomic<std::int64_t>*>(counter) += bytes;
  return true;
}

}  // namespace

BoxHierarchy::BoxHierarchy(std::vector<Object> objects, const Vec3& center,
                           const Callbacks& callbacks, Motion motion)
    : motion_(callbacks.built_in ? Motion::still : motion),
      center_(center),
      objects_(std::move(objects)),
      device_(new_device()),
      traversal_(device_.get()) {
  rtcSetDeviceErrorFunction(device_.get(), throw_embree_error, nullptr);
  rtcSetDeviceMemoryMonitorFunction(device_.get(), count_memory, &embree_bytes_);
  scene_.reset(rtcNewScene(device_.get()));
  if (!callbacks.built_in) rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  if (motion_ == Motion::moving) keep_trees();
  for (Object& object : objects_) {
    object.center = center;
    const auto* mesh = dynamic_cast<const TriangleGeometry*>(object.geometry.get());
    const Geometry geometry = callbacks.built_in && mesh ? triangles(*mesh, callbacks.built_in)
                                                         : boxes(object, callbacks);
    rtcSetGeometryUserData(geometry.get(), &object);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(scene_.get(), geometry.get());
  }
  commit();
}

/// On a thread of its own, which no other work encloses: Embree keeps a task group with each of its
/// scenes, whose context would stay bound to that of the work that builds first, and TBB would
/// follow it there when that is long gone.
void BoxHierarchy::commit() {
  std::exception_ptr error;
  embree_tasks.open();
  std::thread([&] {
    try {
      rtcCommitScene(scene_.get());
    } catch (...) {
      error = std::current_exception();
    }
  }).join();
  embree_tasks.join();
  if (error) std::rethrow_exception(error);
}

/// Embree keeps a tree where all three are asked for: low quality stands for a tree over those of
/// the objects, and their own quality says that they are refitted. Without the flag it builds them
/// anew.
void BoxHierarchy::keep_trees() {
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_DYNAMIC);
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
}

BoxHierarchy::Geometry BoxHierarchy::boxes(const Object& object, const Callbacks& callbacks) const {
  Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
  if (motion_ == Motion::moving)
    rtcSetGeometryBuildQuality(geometry.get(), RTC_BUILD_QUALITY_REFIT);
  rtcSetGeometryUserPrimitiveCount(geometry.get(), object.geometry->box_count());
  rtcSetGeometryBoundsFunction(geometry.get(), give_box, nullptr);
  rtcSetGeometryOccludedFunction(geometry.get(), callbacks.decide);
  rtcSetGeometryIntersectFunction(geometry.get(), callbacks.decide_and_close);
  return geometry;
}

BoxHierarchy::Geometry BoxHierarchy::triangles(const TriangleGeometry& mesh,
                                               RTCFilterFunctionN filter) const {
  Geometry geometry(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_TRIANGLE));
  auto* vertices = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), mesh.positions().size()));
  for (const Vec3& x : mesh.positions())
    for (int k = 0; k < 3; ++k) *vertices++ = float(x[k] - center_[k]);
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), mesh.triangles().size()));
  for (const auto& triangle : mesh.triangles())
    indices = std::copy(triangle.begin(), triangle.end(), indices);
  rtcSetGeometryOccludedFilterFunction(geometry.get(), filter);
  return geometry;
}

bool BoxHierarchy::has_as_many_boxes(const std::vector<Object>& objects) const {
  return std::ranges::equal(objects, objects_, [](const Object& a, const Object& b) {
    return a.geometry->box_count() == b.geometry->box_count();
  });
}

bool BoxHierarchy::move(std::vector<Object>& objects, const Vec3& center) {
  if (motion_ == Motion::still || !has_as_many_boxes(objects)) return false;
  center_ = center;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    objects_[i] = std::move(objects[i]);  // Embree keeps its address
    objects_[i].center = center;
    rtcCommitGeometry(rtcGetGeometry(scene_.get(), unsigned(i)));
  }
  commit();
  return true;
}

std::uint64_t BoxHierarchy::bytes() const {
  std::uint64_t sum = static_cast<std::uint64_t>(embree_bytes_.load());
  for (const Object& object : objects_) sum += object.geometry->bytes();
  return sum;
}

}  // namespace pellucid::groundtruth
