// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "groundtruth/traversal/embree.h"

namespace pellucid::groundtruth {

/// A PacketTraversal lets sixteen rays walk a hierarchy together: at once where the processor has
/// instructions for as many (AVX-512), else eight and eight. Embree by itself would take them one
/// by one there, which takes twice as long. Every ray is asked about every box that it meets, once,
/// and about some others; on processors without AVX so are rays that are not valid.
class PacketTraversal {
 public:
  /// Asks the device what the processor can.
  explicit PacketTraversal(RTCDevice device)
      : sixteen_(rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) {}

  /// Calls the occluded functions and filters of all that the rays meet whose `valid` is -1, not 0.
  void occluded(const int* valid, RTCScene scene, EmbreeContext& context, RTCRay16& rays) const;
  /// Calls the intersect functions instead, which may shorten their rays.
  void intersect(const int* valid, RTCScene scene, EmbreeContext& context, RTCRayHit16& rays) const;

 private:
  bool sixteen_;
};

}  // namespace pellucid::groundtruth
