// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of TabulatedBrdf::lookup (trilinear). The texture holds (rgb * valid, valid): after the hardware's linear filter
// rgb / a is the mean over the valid corners alone, so invalid cells never bleed into valid ones. x is phi_d (repeats),
// y theta_d, z theta_h.
uniform sampler3D table;
uniform float phiPeriod;

// Linear RGB in 1/sr; `valid` is false where all eight corners are invalid.
vec3 evaluateTable(vec3 wi, vec3 wo, out bool valid) {
  vec3 at;
  valid = toHalfDifference(wi, wo, at);
  if (!valid) return vec3(0.0);
  vec3 size = vec3(textureSize(table, 0));
  float phi = at.z < 0.0 ? at.z + phiPeriod : at.z;
  vec3 cell = vec3(phi / phiPeriod * size.x, at.y * (2.0 / pi) * size.y, sqrt(max(0.0, at.x) * (2.0 / pi)) * size.z);
  vec4 value = texture(table, (cell + 0.5) / size);
  valid = value.a > 0.0;
  return valid ? value.rgb / value.a : vec3(0.0);
}
