// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/crossing_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "groundtruth/traversal/crossing_order.h"
#include "groundtruth/traversal/packet_callbacks.h"
#include "groundtruth/traversal/solid_union.h"

namespace pellucid::groundtruth {
namespace {

/// The scene lies within √3 of its centre: a ray is traversed within this distance of its point
/// that is nearest to the centre.
constexpr double reach = 1.75;
/// A ray starts this far behind the eye, so that rounding hides nothing directly in front of it;
/// what lies behind is sorted out in double.
constexpr double behind_eye = 1e-3;

constexpr std::size_t width = RayPacket::width;

/// The opaque spheres, larger by MarchOptions::dilate, where marches end.
std::vector<scene::Isosurface::Ball> march_stops(const scene::Scene& scene,
                                                 const std::optional<MarchOptions>& march) {
  std::vector<scene::Isosurface::Ball> balls;
  if (!march || !march->dilate) return balls;
  for (const scene::SceneObject& object : scene.objects) {
    const auto* points = std::get_if<scene::PointObject>(&object.shape);
    if (!points || !object.opaque || points->profile != scene::PointObject::Profile::sphere)
      continue;
    for (std::size_t i = 0; i < points->set.positions.size(); ++i)
      if (const double radius = points->radius.at(i); radius > 0)
        balls.push_back({points->set.positions[i], radius + *march->dilate});
  }
  return balls;
}

using Objects = std::vector<BoxHierarchy::Object>;

/// `before` are those of another camera, or none.
Objects make_objects(const scene::Scene& scene, const GeometryContext& context,
                     const Objects& before = {}) {
  Objects objects;
  for (std::uint32_t i = 0; i < scene.objects.size(); ++i)
    objects.push_back({make_geometry(scene.objects[i], i, context,
                                     i < before.size() ? before[i].geometry.get() : nullptr),
                       scene.objects[i].opaque});
  return objects;
}

}  // namespace

struct CrossingFinder::State {
  const scene::Scene& scene;
  std::optional<WholeScene> whole;  // that the scene is a part of
  Precision precision;
  std::optional<MarchOptions> march;
  double stop_below;
  BoxHierarchy::Motion motion;
  ViewFrame frame;
  std::unique_ptr<BoxHierarchy> boxes;
  double largest = 0;  // coordinate
  bool any_union = false, any_opaque = false, any_repeats = false;
  bool may_close = false;  // an opaque object may shorten rays

  State(const scene::Scene& scene_, Precision precision_, const std::optional<MarchOptions>& march_,
        double stop_below_, BoxHierarchy::Motion motion_)
      : State(scene_, {}, precision_, march_, stop_below_, motion_) {}
  State(const scene::Scene& part, const WholeScene& whole, Precision precision_)
      : State(part, whole, precision_, {}, 0, BoxHierarchy::Motion::still) {}

  State(const scene::Scene& scene_, const std::optional<WholeScene>& whole_, Precision precision_,
        const std::optional<MarchOptions>& march_, double stop_below_, BoxHierarchy::Motion motion_)
      : scene(scene_),
        whole(whole_),
        precision(precision_),
        march(march_),
        stop_below(stop_below_),
        motion(motion_),
        frame(scene_, bounds()) {
    build(objects());
  }

  const BoxHierarchy& hierarchy() const { return *boxes; }
  /// Of all that is drawn, world.
  Box3 bounds() const { return whole ? whole->bounds : scene.bounds(); }
  Vec3 center() const { return frame.from_world(bounds().center()); }

  Objects objects(const Objects& before = {}) const {
    return make_objects(scene,
                        {frame, scene.camera, scene.lighting, march, stop_below,
                         march_stops(scene, march), whole ? whole->part : scene::PartNumber()},
                        before);
  }

  void build(Objects made) {
    boxes = std::make_unique<BoxHierarchy>(std::move(made), center(), packet_callbacks(precision),
                                           motion);
    summarize();
  }

  void turn() {
    frame = ViewFrame(scene, bounds());
    Objects moved = objects(hierarchy().objects());
    if (boxes->move(moved, center()))
      summarize();
    else
      build(objects());
  }

  void summarize() {
    largest = whole ? whole->largest : 0;
    any_union = any_opaque = any_repeats = may_close = false;
    for (const BoxHierarchy::Object& object : hierarchy().objects()) {
      largest = std::max(largest, object.geometry->largest_coordinate());
      any_union |= object.geometry->is_union();
      any_repeats |= object.geometry->repeats();
      any_opaque |= object.opaque;
      may_close |= object.opaque && !object.geometry->is_union();
    }
    // Hits of Embree's own triangles come to `take` along occlusion rays alone.
    if (precision == Precision::fast) may_close = false;
  }

  void prepare(const PictureRay& ray, std::vector<Crossing>& crossings, std::size_t lane,
               PacketContext& context, RTCRayHit16& traversal) const;
  double exact_depth(const Crossing& crossing, const PictureRay& ray) const {
    return hierarchy().objects()[crossing.object].geometry->exact_depth(crossing, ray);
  }
  bool in_front(const Crossing& crossing, const SceneRay& ray) const;
  void finish(const SceneRay& ray, std::vector<Crossing>& crossings) const;
  void unite(std::vector<Crossing>& crossings) const;
};

/// Leaves of the crossings with unions those with their surfaces.
void CrossingFinder::State::unite(std::vector<Crossing>& crossings) const {
  std::vector<PartCrossing> parts;
  std::erase_if(crossings, [&](const Crossing& crossing) {
    const CrossingGeometry& geometry = *hierarchy().objects()[crossing.object].geometry;
    if (geometry.is_union()) parts.push_back({geometry.solid(crossing), crossing});
    return geometry.is_union();
  });
  append_union(parts, crossings);
}

CrossingFinder::CrossingFinder(const scene::Scene& scene, Precision precision,
                               const std::optional<MarchOptions>& march, double stop_below)
    : state_(std::make_unique<State>(scene, precision, march, stop_below,
                                     BoxHierarchy::Motion::still)) {}

CrossingFinder::CrossingFinder(std::unique_ptr<State> state) : state_(std::move(state)) {}

CrossingFinder CrossingFinder::turning(const scene::Scene& scene, Precision precision,
                                       double stop_below) {
  return CrossingFinder(std::make_unique<State>(scene, precision, std::nullopt, stop_below,
                                                BoxHierarchy::Motion::moving));
}

CrossingFinder::CrossingFinder(const scene::Scene& part, const WholeScene& whole,
                               Precision precision)
    : state_(std::make_unique<State>(part, whole, precision)) {}

CrossingFinder::~CrossingFinder() = default;
CrossingFinder::CrossingFinder(CrossingFinder&& other) noexcept = default;

void CrossingFinder::turn() { state_->turn(); }

const ViewFrame& CrossingFinder::frame() const { return state_->frame; }

void CrossingFinder::State::prepare(const PictureRay& ray, std::vector<Crossing>& crossings,
                                    std::size_t lane, PacketContext& context,
                                    RTCRayHit16& embree) const {
  crossings.clear();
  const bool perspective = ray.projection == scene::Projection::perspective;
  const Vec3 direction = perspective ? glm::normalize(Vec3(ray.x, ray.y, 1)) : Vec3(0, 0, 1);
  const Vec3 eye_point = perspective ? Vec3(0) : Vec3(ray.x, ray.y, 0);
  const Vec3 start = eye_point - hierarchy().center();
  const double nearest = -glm::dot(start, direction);
  const double begin = std::max(nearest - reach, -behind_eye), end = nearest + reach;
  const Vec3 origin = start + begin * direction;
  const DepthDoubt doubt = precision == Precision::exact ? depth_doubt(ray, largest) : DepthDoubt();
  context.rays.rays.push_back({ray, {ray, largest, precision}, eye_point, direction, doubt});
  context.rays.predicate.set(lane, context.rays.rays.back().predicate);
  context.rays.crossings[lane] = &crossings;
  context.begins[lane] = begin;
  RTCRay16& traversal = embree.ray;
  traversal.org_x[lane] = float(origin.x);
  traversal.org_y[lane] = float(origin.y);
  traversal.org_z[lane] = float(origin.z);
  traversal.dir_x[lane] = float(direction.x);
  traversal.dir_y[lane] = float(direction.y);
  traversal.dir_z[lane] = float(direction.z);
  // Negative: nothing is in front of the eye, or the ray passes far beside all of it. Embree
  // refuses rays whose numbers are as large as those of such a one may be.
  const bool passes_beside = !(glm::length(start + nearest * direction) <= 2 * reach);
  traversal.tfar[lane] = passes_beside ? -1 : float(end - begin);
  traversal.mask[lane] = ~0u;
  traversal.id[lane] = unsigned(lane);
}

/// What lies at the eye's own depth is not in front of it, however the view is turned.
bool CrossingFinder::State::in_front(const Crossing& crossing, const SceneRay& ray) const {
  if (!(std::abs(crossing.depth) < ray.doubt.most)) return crossing.depth > 0;
  return exact_depth(crossing, ray.picture) > 0;
}

/// Orders the crossings of a traversal and drops those that are not the ray's.
void CrossingFinder::State::finish(const SceneRay& ray, std::vector<Crossing>& crossings) const {
  if (any_union) unite(crossings);
  std::erase_if(crossings, [&](const Crossing& c) { return !in_front(c, ray); });
  order_crossings(crossings);
  // To the last bit: each box's test is the same.
  const auto repeated = [this](const Crossing& p, const Crossing& q) {
    return p == q && hierarchy().objects()[p.object].geometry->repeats();
  };
  if (any_repeats)
    crossings.erase(std::unique(crossings.begin(), crossings.end(), repeated), crossings.end());
  if (precision == Precision::exact)
    settle_order(
        crossings, ray.doubt.most,
        [&](const Crossing& c) {
          return hierarchy().objects()[c.object].geometry->depth_error(c, ray);
        },
        [&](const Crossing& c) { return exact_depth(c, ray.picture); });
  if (!any_opaque) return;
  const auto opaque = [this](const Crossing& c) { return hierarchy().objects()[c.object].opaque; };
  const auto end_of_ray = std::find_if(crossings.begin(), crossings.end(), opaque);
  if (end_of_ray != crossings.end()) crossings.erase(end_of_ray + 1, crossings.end());
}

void CrossingFinder::find(const PictureRay& ray, std::vector<Crossing>& crossings) const {
  find({&ray, 1}, {&crossings, 1});
}

void CrossingFinder::find(std::span<const PictureRay> rays,
                          std::span<std::vector<Crossing>> crossings) const {
  PacketContext context{};
  start(context.embree);
  // Not as coherent rays: Embree 3.13.5 then brings a candidate twice to rays of which a component
  // of the direction is 0.
  context.rays.rays.reserve(width);  // the packet's test points into it
  RTCRayHit16 traversal{};
  alignas(64) int valid[width] = {};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    state_->prepare(rays[i], crossings[i], i, context, traversal);
    if (!(traversal.ray.tfar[i] >= 0)) continue;
    valid[i] = -1;
    context.walking |= 1u << i;
  }
  if (state_->may_close)
    state_->hierarchy().decide_and_close(valid, context.embree, traversal);
  else
    state_->hierarchy().decide(valid, context.embree, traversal.ray);
  for (std::size_t i = 0; i < rays.size(); ++i) state_->finish(context.rays.rays[i], crossings[i]);
}

void CrossingFinder::round_depths(const PictureRay& ray, std::span<Crossing> crossings) const {
  if (state_->precision != Precision::exact) return;
  for (Crossing& crossing : crossings) crossing.depth = state_->exact_depth(crossing, ray);
}

Fragment CrossingFinder::shade(const Crossing& crossing, const Vec3& world_direction) const {
  Fragment fragment;
  shade({&crossing, 1}, world_direction, {&fragment, 1});
  return fragment;
}

void CrossingFinder::shade(std::span<const Crossing> crossings, const Vec3& world_direction,
                           std::span<Fragment> fragments) const {
  const std::span<const BoxHierarchy::Object> objects = state_->hierarchy().objects();
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const BoxHierarchy::Object& object = objects[crossings[i].object];
    // In place: a copy would read in one piece what was just written in two, and wait for it.
    new (&fragments[i]) Fragment(object.geometry->shade(crossings[i], world_direction));
    if (object.opaque) fragments[i].opacity = 1;
  }
}

double CrossingFinder::importance(const Crossing& crossing) const {
  const BoxHierarchy::Object& object = state_->hierarchy().objects()[crossing.object];
  return object.opaque ? 0 : object.geometry->importance(crossing);
}

std::uint64_t CrossingFinder::bytes() const { return state_->hierarchy().bytes(); }

}  // namespace pellucid::groundtruth
