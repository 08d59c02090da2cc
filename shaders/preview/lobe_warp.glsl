// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "grain.glsl"
#include "math.glsl"

// Twins of core/editing/lobe_change.h.
vec3 turnedBy(vec3 w, vec3 axis, float cosine) {
  return w * cosine + cross(axis, w) + axis * (dot(axis, w) / (1.0 + cosine));
}

const float minWarpCosine = 0.08715574;

float cosineToHorizon(vec3 w, vec3 axis) {
  float along = axis.z * dot(axis, w), up = w.z - along, ahead = axis.x * w.y - axis.y * w.x;
  float inverse = inversesqrt(max(up * up + ahead * ahead, 1e-30));
  float cosine = clamp((minWarpCosine - along) * inverse, -1.0, 1.0), sine = sqrt(1.0 - cosine * cosine);
  float beyond = ahead < 0.0 && w.z < minWarpCosine ? 1.0 : -1.0;
  return ahead * cosine + up * sine >= 0.0 ? (up * cosine - ahead * sine) * inverse : beyond;
}

// Where both scales are one number the compiler leaves out what only a grain needs.
void scaleHalfSlopes(inout vec3 wi, inout vec3 wo, vec2 scale) {
  vec3 h = wi + wo;
  h /= max(length(h), 1e-6);
  vec3 scaled = vec3(scale * h.xy, h.z);
  float inverse = inversesqrt(dot(scaled, scaled));
  vec3 axis = inverse * vec3(h.y * h.z * (1.0 - scale.y), h.x * h.z * (scale.x - 1.0), h.x * h.y * (scale.y - scale.x));
  float cosine = inverse * dot(h, scaled), inverseSine = inversesqrt(max(dot(axis, axis), 1e-30));
  float lowest = min(turnedBy(wi, axis, cosine).z, turnedBy(wo, axis, cosine).z);
  float last = max(cosineToHorizon(wi, axis * inverseSine), cosineToHorizon(wo, axis * inverseSine));
  bool ends = lowest < minWarpCosine && last > cosine;
  axis *= ends ? inverseSine * sqrt(max(0.0, 1.0 - last * last)) : 1.0;
  cosine = ends ? last : cosine;
  wi = turnedBy(wi, axis, cosine);
  wo = turnedBy(wo, axis, cosine);
}

// `grains`: cosine and sine of the rotation of the edited and of the fitted grain.
void scaleHalfSlopesAlongGrain(inout vec3 wi, inout vec3 wo, vec2 scale, vec4 grains) {
  wi = inGrain(wi, grains.xy);
  wo = inGrain(wo, grains.xy);
  scaleHalfSlopes(wi, wo, scale);
  vec2 back = vec2(grains.z, -grains.w);
  wi = inGrain(wi, back);
  wo = inGrain(wo, back);
}

// The ratio that a lobe carries as it changes its colour: twin of core/editing/lobe_change.h.
vec3 recolouredRatio(vec3 ratio, vec3 fitted, vec3 edited) {
  const vec3 weights = vec3(0.2126, 0.7152, 0.0722);
  float before = max(dot(fitted, weights), 1e-30), after = max(dot(edited, weights), 1e-30);
  vec3 kept = min(vec3(1.0), (fitted / before) / max(edited / after, vec3(1e-6)));
  vec3 carried = mix(vec3(dot(fitted * ratio, weights) / before), ratio, kept);
  return min(before, after) > 1e-30 ? carried : ratio;
}

// What the diffuse term carries of a ratio: twin of LobeChange.
vec3 diffuseRatio(vec3 ratio, vec3 diffuse, vec3 model) {
  vec3 part = diffuse / max(model, vec3(1e-30));
  part *= part;
  return 1.0 + part * part * (ratio - 1.0);
}

vec3 diffuseChange(vec3 ratio, vec3 before, vec3 after, vec3 model) {
  vec3 own = diffuseRatio(ratio, before, model);
  return after * recolouredRatio(own, before, after) - before * own;
}

// What a fit does not explain: twin of LobeChange.
vec3 fitRatio(vec3 measured, vec3 fitted) {
  const float epsilon = 0.001;
  return (measured + epsilon) / (fitted + epsilon);
}
