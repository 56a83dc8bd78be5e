#include "groundtruth/crossing_finder.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"

namespace pellucid {
namespace {

/// Boxes grow by this much on every side, in unit lengths. A traversal starts at most 4 unit
/// lengths before the end of the scene, so rounding to float moves a point of the ray by at most
/// half an ulp of 4 for its origin (2.4e-7) plus 4 · 2^-25 for its direction (1.2e-7), and a box by
/// 6e-8.
constexpr float box_margin = 0x1p-20f;  // 9.5e-7

/// The scene lies in [-1, 1]³: a ray is traversed within this distance of its point that is nearest
/// to the origin.
constexpr double reach = 1.75;  // > √3
/// A ray starts this far behind the eye, so that rounding hides nothing directly in front of it;
/// what lies behind is sorted out in double.
constexpr double behind_eye = 1e-3;

struct Object {
  std::vector<Vec3> positions;  // unit frame
  const std::vector<std::array<std::uint32_t, 3>>* triangles;
  std::uint32_t index;
  Precision precision;
};

/// What the callback needs of the ray; Embree hands the context through.
struct RayContext {
  RTCIntersectContext embree;
  const PictureRay* ray;
  Vec3 forward;
  std::vector<Crossing>* crossings;
};

void box_of_triangle(const RTCBoundsFunctionArguments* args) {
  const Object& object = *static_cast<const Object*>(args->geometryUserPtr);
  Box3 box;
  for (const std::uint32_t v : (*object.triangles)[args->primID]) box.extend(object.positions[v]);
  RTCBounds& out = *args->bounds_o;
  out.lower_x = float(box.min.x) - box_margin;
  out.lower_y = float(box.min.y) - box_margin;
  out.lower_z = float(box.min.z) - box_margin;
  out.upper_x = float(box.max.x) + box_margin;
  out.upper_y = float(box.max.y) + box_margin;
  out.upper_z = float(box.max.z) + box_margin;
}

/// Decides one candidate, and never reports a hit to Embree, so that the traversal goes on.
void test_triangle(const RTCOccludedFunctionNArguments* args) {
  const Object& object = *static_cast<const Object*>(args->geometryUserPtr);
  const RayContext& context = *reinterpret_cast<const RayContext*>(args->context);
  const PictureRay& ray = *context.ray;
  const auto& [ia, ib, ic] = (*object.triangles)[args->primID];
  const Vec3 &a = object.positions[ia], &b = object.positions[ib], &c = object.positions[ic];
  EdgeFunctions edges;
  if (!crosses(ray, a, b, c, object.precision, edges)) return;
  const double sum = edges.e[0] + edges.e[1] + edges.e[2];
  // All zero: the unperturbed ray runs along the triangle; its centre stands for the crossing.
  const double u = sum != 0 ? edges.e[1] / sum : 1.0 / 3, v = sum != 0 ? edges.e[2] / sum : 1.0 / 3;
  const double depth = glm::dot(context.forward, (a - ray.origin) + u * (b - a) + v * (c - a));
  if (depth > 0) context.crossings->push_back({depth, u, v, object.index, args->primID});
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
  UnitFrame frame;
  RayGenerator rays;
  std::vector<Object> objects;
  std::atomic<std::int64_t> embree_bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  State(const Scene& from, Precision precision)
      : frame(unit_frame(from)), rays(in_unit_frame(frame, from.camera), from.width, from.height) {
    objects.reserve(from.objects.size());
    for (std::size_t i = 0; i < from.objects.size(); ++i) {
      const TriangleMesh& mesh = from.objects[i].mesh;
      Object object{{}, &mesh.triangles, static_cast<std::uint32_t>(i), precision};
      object.positions.reserve(mesh.positions.size());
      for (const Vec3& x : mesh.positions) object.positions.push_back(frame.from_world(x));
      objects.push_back(std::move(object));
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
    for (Object& object : objects) {
      RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
      rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(object.triangles->size()));
      rtcSetGeometryUserData(geometry, &object);
      rtcSetGeometryBoundsFunction(geometry, box_of_triangle, nullptr);
      rtcSetGeometryOccludedFunction(geometry, test_triangle);
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

PictureRay CrossingFinder::ray(double x, double y) const {
  const RayGenerator& rays = state_->rays;
  const Ray ray = rays.ray(x, y);
  return {ray.origin, ray.direction, rays.step_x(), rays.step_y(), rays.projection()};
}

void CrossingFinder::find(double x, double y, std::vector<Crossing>& crossings) const {
  crossings.clear();
  const PictureRay exact_ray = ray(x, y);
  const double length = glm::length(exact_ray.direction);
  const Vec3 direction = exact_ray.direction / length;
  const double nearest = -glm::dot(exact_ray.origin, direction);
  const double begin = std::max(nearest - reach, -behind_eye), end = nearest + reach;
  if (end < begin) return;
  const Vec3 origin = exact_ray.origin + begin * direction;

  RayContext context{{}, &exact_ray, state_->rays.frame().forward, &crossings};
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
  std::sort(crossings.begin(), crossings.end());
}

std::uint64_t CrossingFinder::bytes() const {
  std::uint64_t sum = static_cast<std::uint64_t>(state_->embree_bytes);
  for (const Object& object : state_->objects) sum += object.positions.size() * sizeof(Vec3);
  return sum;
}

}  // namespace pellucid
