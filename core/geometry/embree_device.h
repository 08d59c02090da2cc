// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace gonio {

/// The Embree device of the process; it exists until the process ends.
RTCDevice embreeDevice();

/// rtcIntersect1() and rtcOccluded1() of one ray; Embree 3 takes a context with each.
inline void intersect(RTCScene scene, RTCRayHit& hit) {
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(scene, &hit);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &hit);
#endif
}
inline void occlude(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
  rtcOccluded1(scene, &ray);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene, &context, &ray);
#endif
}

/// @throws Error with Embree's error number if its last call on this thread failed.
void throwIfEmbreeFailed();

}  // namespace gonio
