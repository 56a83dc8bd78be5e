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

/// Embree hands an EmbreeContext through to callbacks; what they need stands behind it.
#if RTC_VERSION_MAJOR >= 4
using EmbreeContext = RTCRayQueryContext;
#else
using EmbreeContext = RTCIntersectContext;
#endif

/// Prepares a context for a traversal.
inline void start(EmbreeContext& context) {
#if RTC_VERSION_MAJOR >= 4
  rtcInitRayQueryContext(&context);
#else
  rtcInitIntersectContext(&context);
#endif
}

/// Calls the occluded functions and filters of all that the ray meets.
inline void traverse_occluded(RTCScene scene, EmbreeContext& context, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded1(scene, &ray, &arguments);
#else
  rtcOccluded1(scene, &context, &ray);
#endif
}

/// Calls the occluded functions and filters of all that each valid ray meets.
///@{
inline void traverse_occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                              RTCRay8& rays) {
#if RTC_VERSION_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded8(valid, scene, &rays, &arguments);
#else
  rtcOccluded8(valid, scene, &context, &rays);
#endif
}
inline void traverse_occluded(const int* valid, RTCScene scene, EmbreeContext& context,
                              RTCRay16& rays) {
#if RTC_VERSION_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.context = &context;
  rtcOccluded16(valid, scene, &rays, &arguments);
#else
  rtcOccluded16(valid, scene, &context, &rays);
#endif
}
///@}

/// Calls the intersect functions, which may shorten their rays, of all that each valid ray meets.
///@{
inline void traverse_intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                               RTCRayHit8& rays) {
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect8(valid, scene, &rays, &arguments);
#else
  rtcIntersect8(valid, scene, &context, &rays);
#endif
}
inline void traverse_intersect(const int* valid, RTCScene scene, EmbreeContext& context,
                               RTCRayHit16& rays) {
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &context;
  rtcIntersect16(valid, scene, &rays, &arguments);
#else
  rtcIntersect16(valid, scene, &context, &rays);
#endif
}
///@}

}  // namespace pellucid::groundtruth
