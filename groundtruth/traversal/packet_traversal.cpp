// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundtruth/traversal/packet_traversal.h"

#include <algorithm>

namespace pellucid::groundtruth {
namespace {

/// Eight of the rays, from `first` on; their numbers stay.
RTCRay8 eight_of(const RTCRay16& rays, std::size_t first) {
  RTCRay8 eight{};
  const auto copy = [first](const auto& from, auto& to) { std::copy_n(from + first, 8, to); };
  copy(rays.org_x, eight.org_x);
  copy(rays.org_y, eight.org_y);
  copy(rays.org_z, eight.org_z);
  copy(rays.tnear, eight.tnear);
  copy(rays.dir_x, eight.dir_x);
  copy(rays.dir_y, eight.dir_y);
  copy(rays.dir_z, eight.dir_z);
  copy(rays.time, eight.time);
  copy(rays.tfar, eight.tfar);
  copy(rays.mask, eight.mask);
  copy(rays.id, eight.id);
  copy(rays.flags, eight.flags);
  return eight;
}

/// Calls walk(valid, rays) for each eight of which a ray is valid. There is room for hits behind
/// the rays: without AVX Embree 4's rtcOccluded8 reads it before its callbacks, and writes what it
/// has read behind them.
template <class Walk>
void by_eights(const int* valid, const RTCRay16& rays, const Walk& walk) {
  for (const std::size_t first : {0, 8}) {
    alignas(32) int of_eight[8];
    std::copy_n(valid + first, 8, of_eight);
    if (std::ranges::count(of_eight, 0) == 8) continue;
    RTCRayHit8 eight{};
    eight.ray = eight_of(rays, first);
    walk(of_eight, eight);
  }
}

}  // namespace

void PacketTraversal::occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                               RTCRay16& rays) const {
  if (sixteen_) return traverse_occluded(valid, scene, context, rays);
  by_eights(valid, rays, [&](const int* valid_of_eight, RTCRayHit8& eight) {
    traverse_occluded(valid_of_eight, scene, context, eight.ray);
  });
}

void PacketTraversal::intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                                RTCRayHit16& rays) const {
  if (sixteen_) return traverse_intersect(valid, scene, context, rays);
  by_eights(valid, rays.ray, [&](const int* valid_of_eight, RTCRayHit8& eight) {
    traverse_intersect(valid_of_eight, scene, context, eight);
  });
}

}  // namespace pellucid::groundtruth
