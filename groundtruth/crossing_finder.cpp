#include "groundtruth/crossing_finder.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"

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

struct Object {
  std::vector<Vec3> positions;  // view coordinates
  const std::vector<std::array<std::uint32_t, 3>>* triangles;
  /// Embree's primitive k holds the triangles groups[k] … groups[k + 1] - 1.
  std::vector<std::uint32_t> groups;
  std::uint32_t index;
  const Vec3* center;  // of the scene: Embree's origin, so that its floats are as fine as can be
};

/// What the callback needs of the ray; Embree hands the context through.
struct RayContext {
  RTCIntersectContext embree;
  const CrossingTest* test;
  std::vector<Crossing>* crossings;
};

Box3 box_of(const Object& object, std::uint32_t first, std::uint32_t last) {
  Box3 box;
  for (std::uint32_t t = first; t < last; ++t)
    for (const std::uint32_t v : (*object.triangles)[t]) box.extend(object.positions[v]);
  return box;
}

double half_area(const Box3& box) {
  const Vec3 d = box.max - box.min;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Two triangles that follow each other become one primitive when their common box is hardly larger
/// than their own, as in the quadrilaterals of a ribbon: half the boxes to visit, as many tests.
std::vector<std::uint32_t> group_triangles(const Object& object) {
  constexpr double worth_it = 0.7;  // of the sum of the areas; a quadrilateral has 0.5
  const auto count = static_cast<std::uint32_t>(object.triangles->size());
  std::vector<std::uint32_t> groups;
  for (std::uint32_t t = 0; t < count;) {
    groups.push_back(t);
    const bool pair = t + 1 < count && half_area(box_of(object, t, t + 2)) <
                                           worth_it * (half_area(box_of(object, t, t + 1)) +
                                                       half_area(box_of(object, t + 1, t + 2)));
    t += pair ? 2 : 1;
  }
  groups.push_back(count);
  return groups;
}

void box_of_group(const RTCBoundsFunctionArguments* args) {
  const Object& object = *static_cast<const Object*>(args->geometryUserPtr);
  const Box3 box = box_of(object, object.groups[args->primID], object.groups[args->primID + 1]);
  const Vec3 low = box.min - *object.center, high = box.max - *object.center;
  RTCBounds& out = *args->bounds_o;
  out.lower_x = float(low.x) - box_margin;
  out.lower_y = float(low.y) - box_margin;
  out.lower_z = float(low.z) - box_margin;
  out.upper_x = float(high.x) + box_margin;
  out.upper_y = float(high.y) + box_margin;
  out.upper_z = float(high.z) + box_margin;
}

void test_triangle(const Object& object, std::uint32_t triangle, const RayContext& context) {
  const auto& [ia, ib, ic] = (*object.triangles)[triangle];
  const Vec3 &a = object.positions[ia], &b = object.positions[ib], &c = object.positions[ic];
  EdgeFunctions edges;
  if (!context.test->crosses(a, b, c, edges)) return;
  const double sum = edges.e[0] + edges.e[1] + edges.e[2];
  // All zero: the unperturbed ray runs along the triangle; its centre stands for the crossing.
  const double u = sum != 0 ? edges.e[1] / sum : 1.0 / 3, v = sum != 0 ? edges.e[2] / sum : 1.0 / 3;
  const double depth = a.z + u * (b.z - a.z) + v * (c.z - a.z);
  if (depth > 0) context.crossings->push_back({depth, u, v, object.index, triangle});
}

/// Decides the candidates of a group, and never reports a hit to Embree, so that the traversal goes
/// on.
void test_group(const RTCOccludedFunctionNArguments* args) {
  const Object& object = *static_cast<const Object*>(args->geometryUserPtr);
  const RayContext& context = *reinterpret_cast<const RayContext*>(args->context);
  const std::uint32_t last = object.groups[args->primID + 1];
  for (std::uint32_t t = object.groups[args->primID]; t < last; ++t)
    test_triangle(object, t, context);
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
  Vec3 center;         // of the scene, view coordinates
  double largest = 0;  // coordinate
  std::vector<Object> objects;
  std::atomic<std::int64_t> embree_bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;

  State(const Scene& from, Precision precision_)
      : frame(from), precision(precision_), center(frame.from_world(from.bounds().center())) {
    objects.reserve(from.objects.size());
    for (const SceneObject& object : from.objects) add(object.mesh());
    build();
  }

  void add(const TriangleMesh& mesh) {
    Object object{{}, &mesh.triangles, {}, static_cast<std::uint32_t>(objects.size()), &center};
    object.positions.reserve(mesh.positions.size());
    for (const Vec3& x : mesh.positions) {
      const Vec3 v = frame.from_world(x);
      largest = std::max({largest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
      object.positions.push_back(v);
    }
    object.groups = group_triangles(object);
    objects.push_back(std::move(object));
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
      rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(object.groups.size() - 1));
      rtcSetGeometryUserData(geometry, &object);
      rtcSetGeometryBoundsFunction(geometry, box_of_group, nullptr);
      rtcSetGeometryOccludedFunction(geometry, test_group);
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
  const Vec3 start = (perspective ? Vec3(0) : Vec3(ray.x, ray.y, 0)) - state_->center;
  const double nearest = -glm::dot(start, direction);
  const double begin = std::max(nearest - reach, -behind_eye), end = nearest + reach;
  if (end < begin) return;
  const Vec3 origin = start + begin * direction;

  const CrossingTest test(ray, state_->largest, state_->precision);
  RayContext context{{}, &test, &crossings};
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
  for (const Object& object : state_->objects)
    sum += object.positions.size() * sizeof(Vec3) + object.groups.size() * sizeof(std::uint32_t);
  return sum;
}

}  // namespace pellucid
