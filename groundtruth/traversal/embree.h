// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Embree 3 and Embree 4, whose calls differ in how a traversal gets its context. Both bring the
// same callbacks the same candidates.

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace pellucid::groundtruth {

#if RTC_VERSION_MAJOR >= 4

/// Embree hands it through to callbacks; what they need stands behind it.
using EmbreeContext = RTCRayQueryContext;

inline void start(EmbreeContext& context) { rtcInitRayQueryContext(&context); }

/// Calls the occluded functions and filters of all that each valid ray meets.
///@{
inline void traverse_occluded(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
}
inline void traverse_occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                              RTCRay8& rays) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded8(valid, scene, &rays, &arguments);
}
///@}

/// Calls the intersect functions, which may shorten their rays.
inline void traverse_intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                               RTCRayHit8& rays) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect8(valid, scene, &rays, &arguments);
}

#else

using EmbreeContext = RTCIntersectContext;

inline void start(EmbreeContext& context) { rtcInitIntersectContext(&context); }

inline void traverse_occluded(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
  rtcOccluded1(scene, &context, &ray);
}
inline void traverse_occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                              RTCRay8& rays) {
  rtcOccluded8(valid, scene, &context, &rays);
}
inline void traverse_intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                               RTCRayHit8& rays) {
  rtcIntersect8(valid, scene, &context, &rays);
}

#endif

}  // namespace pellucid::groundtruth
