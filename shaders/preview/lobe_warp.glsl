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

// With DifferentialEdit::keepsAlbedo.
vec3 closeFitRatio(vec3 measured, vec3 fitted) {
  return min(1.0 + (measured - fitted) * fitted / (fitted * fitted + 1e-6), measured / max(fitted, vec3(1e-30)));
}

float luminanceOf(vec3 value) { return dot(value, vec3(0.2126, 0.7152, 0.0722)); }

// `width`: 1 / (3 alpha) along and across the grain, cosine and sine of its rotation.
float centreOf(vec3 h, vec4 width) {
  vec2 slope = vec2(dot(width.zw, h.xy), width.z * h.y - width.w * h.x) * width.xy;
  float squared = dot(slope, slope) / max(h.z * h.z, 1e-12);
  return 1.0 / (1.0 + squared * squared);
}

float peakOf(vec3 measured, float model) { return smoothstep(1.25, 2.25, (luminanceOf(measured) + 0.001) / (model + 0.001)); }

vec3 excessOf(vec3 rest) { return 1.0 + rest * (1.0 + rest * (1.0 + rest * (1.0 + rest))); }

float fourthPower(float x) {
  x *= x;
  return x * x;
}

// Between which nodes of AlbedoScale a direction is.
const int albedoNodes = ALBEDO_NODES;
float albedoPlace(float cosine) {
  float x = sqrt(1.0 - clamp(cosine, 0.0, 1.0));
  return 0.5 * x * (1.0 + x) * float(albedoNodes - 1);
}
#define ALBEDO_SCALE(values, place) mix(values[min(int(place), albedoNodes - 2)], values[min(int(place), albedoNodes - 2) + 1], place - float(min(int(place), albedoNodes - 2)))
