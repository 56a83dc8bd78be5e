// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/packet_traversal.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace pellucid::groundtruth {
namespace {

constexpr unsigned width = 16, boxes = 40;

/// A box and the ray that was asked about it.
using Candidates = std::multiset<std::pair<unsigned, unsigned>>;

struct Context {
  EmbreeContext embree;
  Candidates* candidates;
};

/// Box k reaches from 0 to k / 2 along x; box boxes - 1 all the way along y, half of the rays pass
/// above the others.
void give_box(const RTCBoundsFunctionArguments* args) {
  const auto k = float(args->primID);
  *args->bounds_o = {0, 0, k, 0, k / 2, args->primID + 1 == boxes ? 4.f : 2.f, k + 0.5f, 0};
}

template <class Arguments>
void record(const Arguments& args, RTCRayN* rays) {
  auto& candidates = *reinterpret_cast<Context*>(args.context)->candidates;
  for (unsigned i = 0; i < args.N; ++i)
    if (args.valid[i]) candidates.emplace(args.primID, RTCRayN_id(rays, args.N, i));
}

/// Which boxes rays are asked about by a device with these settings.
Candidates candidates(const char* settings, bool intersect) {
  const RTCDevice device = rtcNewDevice(settings);
  const RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, boxes);
  rtcSetGeometryBoundsFunction(geometry, give_box, nullptr);
  rtcSetGeometryOccludedFunction(
      geometry, [](const RTCOccludedFunctionNArguments* args) { record(*args, args->ray); });
  rtcSetGeometryIntersectFunction(geometry, [](const RTCIntersectFunctionNArguments* args) {
    record(*args, RTCRayHitN_RayN(args->rayhit, args->N));
  });
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);

  RTCRayHit16 rays{};
  alignas(64) int valid[width] = {};
  for (unsigned i = 0; i < width; ++i) {
    rays.ray.org_x[i] = 0.25f + float(i);
    rays.ray.org_y[i] = i % 2 ? 1 : 3;
    rays.ray.org_z[i] = -1;
    rays.ray.dir_z[i] = 1;
    rays.ray.tfar[i] = 100;
    rays.ray.mask[i] = ~0u;
    rays.ray.id[i] = i;
    valid[i] = i == 5 ? 0 : -1;
  }
  Candidates found;
  Context context{{}, &found};
  start(context.embree);
  const PacketTraversal traversal(device);
  if (intersect)
    traversal.intersect(valid, scene, context.embree, rays);
  else
    traversal.occluded(valid, scene, context.embree, rays.ray);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return found;
}

/// Which they have to be asked about; a packet may ask about more. Ray 5 is not valid.
Candidates met() {
  Candidates pairs;
  for (unsigned box = 0; box < boxes; ++box)
    for (unsigned ray = 0; ray < width; ++ray)
      if (ray != 5 && 0.25 + ray <= box / 2.0 && (ray % 2 || box + 1 == boxes))
        pairs.emplace(box, ray);
  return pairs;
}

// Without AVX-512 it walks by eights; where the processor has none both walks do.
TEST(UnitPacketTraversal, AsksEveryRayOnceAboutEveryBoxThatItMeets) {
  for (const char* settings : {"", "isa=avx2", "isa=sse2"})
    for (const bool intersect : {false, true}) {
      const Candidates found = candidates(settings, intersect);
      for (const auto& pair : met())
        EXPECT_EQ(found.count(pair), 1u) << settings << " " << pair.first << " " << pair.second;
      EXPECT_EQ(std::set(found.begin(), found.end()).size(), found.size()) << "asked twice";
    }
}

}  // namespace
}  // namespace pellucid::groundtruth
