// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/factorization/pdv_brdf.cpp: a reflectance straight from its factor curves. `factorCurves` holds, for
// each axis (F1 over theta_R, F2 over |Dp|, F3 over |phi|), two rows a term: values and slopes at the nodes in rgb; the
// nodes themselves in the alpha of the values. Rows of the original curves follow those of the edited ones.
#include "math.glsl"

uniform sampler2D factorCurves;
uniform int factorTerms;
uniform vec3 factorNodes[2];       // count of nodes of the three axes: edited, original
uniform float factorHighest[2];
uniform int factorTransform[2];    // DataTransform

struct FactorPlace {
  int index;
  vec4 weights;  // of value, next value, slope, next slope
};

FactorPlace factorPlace(int row, int count, float x) {
  FactorPlace place = FactorPlace(0, vec4(1.0, 0.0, 0.0, 0.0));
  if (count < 2) return place;
  int low = 0, high = count - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (texelFetch(factorCurves, ivec2(middle, row), 0).a <= x)
      low = middle;
    else
      high = middle;
  }
  float before = texelFetch(factorCurves, ivec2(low, row), 0).a;
  float span = texelFetch(factorCurves, ivec2(low + 1, row), 0).a - before;
  float t = clamp((x - before) / span, 0.0, 1.0), s = 1.0 - t;
  place.index = low;
  place.weights = vec4(s * s * (1.0 + 2.0 * t), t * t * (1.0 + 2.0 * s), span * t * s * s, -span * t * t * s);
  return place;
}

vec3 factorCurve(FactorPlace place, int row) {
  ivec2 at = ivec2(place.index, row);
  if (place.weights.x == 1.0) return texelFetch(factorCurves, at, 0).rgb;
  return place.weights.x * texelFetch(factorCurves, at, 0).rgb +
         place.weights.y * texelFetch(factorCurves, at + ivec2(1, 0), 0).rgb +
         place.weights.z * texelFetch(factorCurves, at + ivec2(0, 1), 0).rgb +
         place.weights.w * texelFetch(factorCurves, at + ivec2(1, 1), 0).rgb;
}

vec3 factorInverse(int transform, vec3 y, float weight) {
  if (transform <= 1) {
    vec3 value = vec3(expMinusOne(y.r), expMinusOne(y.g), expMinusOne(y.b));
    return transform == 0 ? value : value / weight;
  }
  return transform == 2 ? y * y : y;
}

// theta_R, |Dp|, |phi|.
vec3 projectedDeviation(vec3 wi, vec3 wo) {
  float sinR = length(wo.xy);
  vec2 o = sinR > 0.0 ? wo.xy / sinR : vec2(1.0, 0.0);
  vec2 deviation = vec2(dot(o, wi.xy) + sinR, o.x * wi.y - o.y * wi.x);
  float size = length(deviation);
  float acute = acuteAngle(abs(deviation.y), abs(deviation.x));
  return vec3(acuteAngle(sinR, wo.z), size, deviation.x < 0.0 ? pi - acute : acute);
}

// Linear RGB in 1/sr of the edited (0) or the original (1) curves.
vec3 evaluateFactors(vec3 wi, vec3 wo, int which) {
  vec3 at = projectedDeviation(wi, wo);
  ivec3 counts = ivec3(factorNodes[which]);
  int row = which * 6 * factorTerms;
  FactorPlace f1 = factorPlace(row, counts.x, at.x);
  FactorPlace f2 = factorPlace(row + 2 * factorTerms, counts.y, at.y);
  FactorPlace f3 = factorPlace(row + 4 * factorTerms, counts.z, at.z);
  vec3 sum = vec3(0.0);
  for (int term = 0; term < factorTerms; ++term)
    sum += factorCurve(f1, row + 2 * term) * factorCurve(f2, row + 2 * (factorTerms + term)) *
           factorCurve(f3, row + 2 * (2 * factorTerms + term));
  vec3 y = clamp(sum, vec3(0.0), vec3(factorHighest[which]));
  return factorInverse(factorTransform[which], y, max(wi.z * wo.z, 1e-3));
}
