#pragma once

#include <embree4/rtcore.h>

// What we use of Embree 3, in terms of Embree 4, which took the context out of the queries. On the include
// path only where there is no Embree 3.

struct RTCIntersectContext {};

inline void rtcInitIntersectContext(RTCIntersectContext* /*context*/) {}

inline void rtcIntersect1(RTCScene scene, RTCIntersectContext* /*context*/, RTCRayHit* rayhit) {
  rtcIntersect1(scene, rayhit);
}

inline void rtcOccluded1(RTCScene scene, RTCIntersectContext* /*context*/, RTCRay* ray) {
  rtcOccluded1(scene, ray);
}
