// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/editing/lobe_warp.h: the directions of a half vector with `scale` times the tangent of its polar angle.
void scaleHalfTangent(inout vec3 wi, inout vec3 wo, float scale) {
  vec3 sum = wi + wo;
  float across = length(sum.xy);
  if (across <= 1e-6) return;
  vec2 axis = sum.xy / across;
  float turn = atan(scale * across, sum.z) - atan(across, sum.z);
  vec2 along = vec2(dot(wi.xy, axis), dot(wo.xy, axis));
  const float lastAngle = 0.5 * pi - 0.01;
  turn = min(turn, max(0.0, lastAngle - max(atan(along.x, wi.z), atan(along.y, wo.z))));
  float cosine = cos(turn), sine = sin(turn);
  wi = vec3(wi.xy + (along.x * (cosine - 1.0) + wi.z * sine) * axis, wi.z * cosine - along.x * sine);
  wo = vec3(wo.xy + (along.y * (cosine - 1.0) + wo.z * sine) * axis, wo.z * cosine - along.y * sine);
}

// The ratio that a lobe carries as it changes its colour: twin of core/editing/lobe_change.h.
vec3 recolouredRatio(vec3 ratio, vec3 fitted, vec3 edited) {
  const vec3 weights = vec3(0.2126, 0.7152, 0.0722);
  float before = max(dot(fitted, weights), 1e-30), after = max(dot(edited, weights), 1e-30);
  vec3 kept = min(vec3(1.0), (fitted / before) / max(edited / after, vec3(1e-6)));
  vec3 carried = mix(vec3(dot(fitted * ratio, weights) / before), ratio, kept);
  return min(before, after) > 1e-30 ? carried : ratio;
}

// What the body carries of a ratio: twin of LobeChange.
vec3 bodyRatio(vec3 ratio, vec3 body, vec3 model) {
  vec3 part = body / max(model, vec3(1e-30));
  part *= part;
  return 1.0 + part * part * (ratio - 1.0);
}

// What a fit does not explain: twin of LobeChange.
vec3 fitRatio(vec3 measured, vec3 fitted) {
  const float epsilon = 0.001;
  return (max(measured, vec3(0.0)) + epsilon) / (fitted + epsilon);
}
