// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/factorization/pdv_brdf.cpp: BRDF values straight from factor curves, read from a small buffer that
// widgets/preview/gl/edit_chain.h fills, one edit behind the other: rgb by place, set, term, axis, the last fastest,
// so that all terms at a place lie side by side. `terms` and `axes` (2: F1 F2, 3: and F3) are constants of the step that
// calls.
//   FACTOR_EDITS  how many edits
#include "preview/data_transform.glsl"

uniform samplerBuffer factorCurves;
uniform int factorPlaceCount;
uniform int factorFirst[FACTOR_EDITS];          // texel of each edit
uniform vec3 factorEnds[FACTOR_EDITS];          // of theta_R, |Dp|, |phi|
uniform vec2 factorLimits[2 * FACTOR_EDITS];    // lowest and highest y; edited, original
uniform int factorTransform[2 * FACTOR_EDITS];  // DataTransform

// The places are even in theta_R, in the root of |Dp| and in |phi|.
vec3 factorPlaces(vec3 wi, vec3 wo, int edit, int axes) {
  float sinR = length(wo.xy);
  vec2 o = sinR > 0.0 ? wo.xy / sinR : vec2(1.0, 0.0);
  vec2 deviation = vec2(dot(o, wi.xy) + sinR, o.x * wi.y - o.y * wi.x);
  vec3 at = vec3(acuteAngle(sinR, wo.z), length(deviation), 0.0);
  if (axes == 3) {
    float acute = acuteAngle(abs(deviation.y), abs(deviation.x));
    at.z = deviation.x < 0.0 ? pi - acute : acute;
  }
  vec3 fraction = clamp(at / factorEnds[edit], 0.0, 1.0);
  fraction.y = sqrt(fraction.y);
  return fraction * float(factorPlaceCount - 1);
}

// By hand: drivers filter with weights of a few bits.
vec3 factorCurve(int at, int stride, float fraction) {
  return mix(texelFetch(factorCurves, at).rgb, texelFetch(factorCurves, at + stride).rgb, fraction);
}

// Linear RGB in 1/sr of the edited (0) or the original (1) curves at factorPlaces().
vec3 evaluateFactors(vec3 places, float cosines, int edit, int set, int terms, int axes) {
  int stride = 2 * terms * axes;
  vec3 sum = vec3(0.0);
  vec3 before = min(floor(places), float(factorPlaceCount - 2));
  ivec3 at = factorFirst[edit] + ivec3(before) * stride + set * terms * axes;
  vec3 fraction = places - before;
  for (int term = 0; term < terms; ++term) {
    vec3 product = factorCurve(at.x, stride, fraction.x) * factorCurve(at.y + 1, stride, fraction.y);
    if (axes == 3) product *= factorCurve(at.z + 2, stride, fraction.z);
    at += axes;
    sum += product;
  }
  int curves = 2 * edit + set;
  vec3 y = clamp(sum, vec3(factorLimits[curves].x), vec3(factorLimits[curves].y));
  return sign(y) * inverseTransformed(factorTransform[curves], abs(y), cosines);
}

// BRDF values with an edit of the curves: by their difference (the detail kept), or the curves in their place.
vec3 editedByFactors(vec3 value, vec3 wi, vec3 wo, int edit, int terms, int axes, bool keepDetail, float strength) {
  vec3 places = factorPlaces(wi, wo, edit, axes);
  float cosines = wi.z * wo.z;
  vec3 edited = evaluateFactors(places, cosines, edit, 0, terms, axes);
  vec3 from = value;
  if (keepDetail) from = evaluateFactors(places, cosines, edit, 1, terms, axes);
  return max(min(value, vec3(0.0)), value + strength * (edited - from));
}
