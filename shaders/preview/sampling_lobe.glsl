// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/tabulated_lobe.h: a cosine part and half vectors drawn from the material's own values, tabulated for
// some viewers.
#include "preview/marginal_warp.glsl"
#include "preview/normal_square.glsl"

uniform sampler3D lobeCells;
uniform sampler2D lobeRows;
uniform float lobeCosineShare;  // 1 while the lobe is not known

Slices lobeSlices(vec3 wo) {
  float count = float(textureSize(lobeCells, 0).z);
  float theta = acuteAngle(length(wo.xy), wo.z);
  float place = (count - 1.0) * (1.0 - pow(max(0.0, 1.0 - theta / (0.4995 * pi)), 1.0 / 1.5));
  float at = (clamp(place, 0.0, count - 1.0) + 0.5) / count;
  return Slices(at, at, 0.0);
}

// A direction on the wrong side means that nothing was drawn.
vec3 sampleLobe(vec3 wo, vec3 u) {
  if (u.x >= lobeCosineShare) {
    vec2 square = warpSample(lobeCells, lobeRows, u.yz, lobeSlices(wo));
    square.x *= square.x;
    vec3 normal = fromNormalSquare(square, azimuthOf(wo));
    return dot(wo, normal) > 0.0 ? reflect(-wo, normal) : vec3(0.0, 0.0, -1.0);
  }
  float r = sqrt(u.y);
  return vec3(r * cos(2.0 * pi * u.z), r * sin(2.0 * pi * u.z), sqrt(max(0.0, 1.0 - u.y)));
}

// Density of sampleLobe at wi, 1/sr.
float lobeDensity(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0) return 0.0;
  vec3 normal = normalize(wi + wo);
  vec2 square = toNormalSquare(normal, azimuthOf(wo));
  float x = sqrt(square.x);
  float tabulated = warpDensity(lobeCells, vec2(x, square.y), lobeSlices(wo)) * squarePerSolidAngle(square, normal, wo) / (2.0 * max(x, 1e-6));
  return mix(tabulated, wi.z / pi, lobeCosineShare);
}
