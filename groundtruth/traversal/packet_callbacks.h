// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What Embree calls along the traversal of a packet: candidates become crossings of its rays.

#include <array>

#include "groundtruth/rays/exact_sign.h"
#include "groundtruth/traversal/box_hierarchy.h"

namespace pellucid::groundtruth {

/// A PacketContext is what callbacks need of the rays; Embree hands it through.
struct PacketContext {
  EmbreeContext embree;   // the first
  std::uint32_t walking;  // bit i: ray i; Embree may ask about others (PacketTraversal)
  std::array<double, RayPacket::width> begins;  // of the traversals, from the rays' starts
  RayPacket rays;
};

/// Returns the callbacks that append the packet's crossings to its lists. They never report a hit
/// to Embree, so that the traversal goes on.
BoxHierarchy::Callbacks packet_callbacks(Precision precision);

}  // namespace pellucid::groundtruth
