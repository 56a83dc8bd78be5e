// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/packet_callbacks.h"

#include <algorithm>

namespace pellucid::groundtruth {
namespace {

/// The packet's rays that a callback is about.
template <class Arguments>
std::uint32_t valid_lanes(const Arguments& args, RTCRayN* rays, const PacketContext& context) {
  std::uint32_t lanes = 0;
  for (unsigned i = 0; i < args.N; ++i)
    if (args.valid[i]) lanes |= 1u << RTCRayN_id(rays, args.N, i);
  return lanes & context.walking;
}

/// Decides the candidates of a box, and never reports a hit to Embree, so that the traversal goes
/// on.
void decide(const RTCOccludedFunctionNArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const PacketContext& context = *reinterpret_cast<const PacketContext*>(args->context);
  object.geometry->cross(args->primID, context.rays, valid_lanes(*args, args->ray, context));
}

/// Closes a traversal behind the nearest of these crossings, all with an opaque object: nothing
/// behind it counts but what may turn out to be in front. Boxes are widened by what the ray's
/// rounding moves it; twice that also covers the rounding of the traversal's end.
void close(float& far, const SceneRay& ray, double begin, std::span<const Crossing> crossings) {
  for (const Crossing& crossing : crossings)
    if (crossing.depth > ray.doubt.most)
      far = std::min(far, float((crossing.depth + ray.doubt.most) / ray.direction.z - begin) +
                              2 * BoxHierarchy::margin);
}

/// As decide(); but a ray that an opaque object stops is not asked about boxes that lie behind.
void decide_and_close(const RTCIntersectFunctionNArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const PacketContext& context = *reinterpret_cast<const PacketContext*>(args->context);
  RTCRayN* rays = RTCRayHitN_RayN(args->rayhit, args->N);
  std::array<std::size_t, RayPacket::width> known;
  const std::size_t count = context.rays.rays.size();
  for (std::size_t k = 0; k < count; ++k) known[k] = context.rays.crossings[k]->size();
  const std::uint32_t lanes = valid_lanes(*args, rays, context);
  object.geometry->cross(args->primID, context.rays, lanes);
  // A crossing with a part of a solid may lie within another part.
  if (!object.opaque || object.geometry->is_union()) return;
  for (unsigned i = 0; i < args->N; ++i) {
    const unsigned k = RTCRayN_id(rays, args->N, i);
    if (!args->valid[i] || (lanes >> k & 1) == 0) continue;
    close(RTCRayN_tfar(rays, args->N, i), context.rays.rays[k], context.begins[k],
          std::span(*context.rays.crossings[k]).subspan(known[k]));
  }
}

/// Takes every hit of a mesh as it is, its depth from the ray's float parameter, and rejects it, so
/// that the traversal goes on.
void take(const RTCFilterFunctionNArguments* args) {
  const auto& object = *static_cast<const BoxHierarchy::Object*>(args->geometryUserPtr);
  const auto& mesh = static_cast<const TriangleGeometry&>(*object.geometry);
  const PacketContext& context = *reinterpret_cast<const PacketContext*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    args->valid[i] = 0;
    const unsigned lane = RTCRayN_id(args->ray, args->N, i);
    if ((context.walking >> lane & 1) == 0) continue;
    const double t = context.begins[lane] + RTCRayN_tfar(args->ray, args->N, i);
    context.rays.crossings[lane]->push_back(
        {t * context.rays.rays[lane].direction.z, RTCHitN_u(args->hit, args->N, i),
         RTCHitN_v(args->hit, args->N, i), mesh.index(), RTCHitN_primID(args->hit, args->N, i)});
  }
}

}  // namespace

BoxHierarchy::Callbacks packet_callbacks(Precision precision) {
  return {decide, decide_and_close, precision == Precision::fast ? take : nullptr};
}

}  // namespace pellucid::groundtruth
