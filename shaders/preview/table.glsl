// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of TabulatedBrdf::lookup (trilinear). The texture holds (rgb * valid, valid): after the hardware's linear filter
// rgb / a is the mean over the valid corners alone, so invalid cells never bleed into valid ones. x is phi_d (repeats),
// y theta_d, z theta_h.
#include "half_difference.glsl"

uniform sampler3D table;
uniform float phiPeriod;

// Where half-difference coordinates are among the nodes of a texture.
vec3 tablePlace(vec3 size, float period, vec3 at) {
  float phi = at.z < 0.0 ? at.z + period : at.z;
  return vec3(phi / period * size.x, at.y * (2.0 / pi) * size.y, sqrt(max(0.0, at.x) * (2.0 / pi)) * size.z);
}

// The filtered texel at half-difference coordinates; its alpha is 0 where all eight corners are invalid.
vec4 tableAt(sampler3D values, float period, vec3 at) {
  vec3 size = vec3(textureSize(values, 0));
  return texture(values, (tablePlace(size, period, at) + 0.5) / size);
}

// Linear RGB in 1/sr; `valid` is false where all eight corners are invalid.
vec3 tableValue(vec3 at, inout bool valid) {
  vec4 value = tableAt(table, phiPeriod, at);
  valid = valid && value.a > 0.0;
  return valid ? value.rgb / value.a : vec3(0.0);
}

vec3 evaluateTable(vec3 wi, vec3 wo, out bool valid) {
  vec3 at;
  valid = toHalfDifference(wi, wo, at);
  return tableValue(at, valid);
}

// At `moved`, which is the half vector of both directions after they were turned in its plane with the normal: theta_d
// and phi_d stay.
vec3 evaluateTableInPlane(vec3 wi, vec3 wo, vec3 moved, out bool valid) {
  vec3 at;
  valid = toHalfDifference(wi, wo, at);
  at.x = atan(length(moved.xy), moved.z);
  return tableValue(at, valid);
}
