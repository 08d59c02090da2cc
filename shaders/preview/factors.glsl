// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/factorization/pdv_brdf.cpp: a reflectance straight from its factor curves, read from a small buffer that
// widgets/preview/factor_texture.h fills: rgb by place, set, term, axis, the last fastest, so that all terms at a place
// lie side by side. FACTOR_TERMS and FACTOR_AXES (2: F1 F2, 3: and F3) are set by the renderer.
#include "preview/data_transform.glsl"

uniform samplerBuffer factorCurves;
uniform int factorPlaceCount;
const int factorStride = 2 * FACTOR_TERMS * FACTOR_AXES;
uniform vec3 factorEnds;           // of theta_R, |Dp|, |phi|
uniform float factorHighest[2];    // edited, original
uniform int factorTransform[2];    // DataTransform

// The places are even in theta_R, in the root of |Dp| and in |phi|.
vec3 factorPlaces(vec3 wi, vec3 wo) {
  float sinR = length(wo.xy);
  vec2 o = sinR > 0.0 ? wo.xy / sinR : vec2(1.0, 0.0);
  vec2 deviation = vec2(dot(o, wi.xy) + sinR, o.x * wi.y - o.y * wi.x);
  vec3 at = vec3(acuteAngle(sinR, wo.z), length(deviation), 0.0);
#if FACTOR_AXES == 3
  float acute = acuteAngle(abs(deviation.y), abs(deviation.x));
  at.z = deviation.x < 0.0 ? pi - acute : acute;
#endif
  vec3 share = clamp(at / factorEnds, 0.0, 1.0);
  share.y = sqrt(share.y);
  return share * float(factorPlaceCount - 1);
}

// By hand: drivers filter with weights of a few bits.
vec3 factorCurve(int at, float share) {
  return mix(texelFetch(factorCurves, at).rgb, texelFetch(factorCurves, at + factorStride).rgb, share);
}

// Linear RGB in 1/sr of the edited (0) or the original (1) curves at factorPlaces().
vec3 evaluateFactors(vec3 places, float cosines, int set) {
  vec3 sum = vec3(0.0);
  vec3 before = min(floor(places), float(factorPlaceCount - 2));
  ivec3 at = ivec3(before) * factorStride + set * FACTOR_TERMS * FACTOR_AXES;
  vec3 share = places - before;
  for (int term = 0; term < FACTOR_TERMS; ++term) {
    vec3 product = factorCurve(at.x, share.x) * factorCurve(at.y + 1, share.y);
#if FACTOR_AXES == 3
    product *= factorCurve(at.z + 2, share.z);
#endif
    at += FACTOR_AXES;
    sum += product;
  }
  return inverseTransformed(factorTransform[set], clamp(sum, vec3(0.0), vec3(factorHighest[set])), cosines);
}
