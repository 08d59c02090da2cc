// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/sampling_lobe.h: a cosine part and the visible normals of a GGX lobe (Heitz 2018).
uniform float lobeRoughness;
uniform float lobeSpecularShare;

vec3 sampleVisibleNormal(vec3 wo, float alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * wo.xy, wo.z));
  float squaredLength = dot(stretched.xy, stretched.xy);
  vec3 tangent = squaredLength > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) * inversesqrt(squaredLength) : vec3(1, 0, 0);
  vec3 bitangent = cross(stretched, tangent);
  float r = sqrt(u.x);
  float phi = 2.0 * pi * u.y;
  float t1 = r * cos(phi);
  float t2 = r * sin(phi);
  float s = 0.5 * (1.0 + stretched.z);
  t2 = (1.0 - s) * sqrt(max(0.0, 1.0 - t1 * t1)) + s * t2;
  vec3 n = t1 * tangent + t2 * bitangent + sqrt(max(0.0, 1.0 - t1 * t1 - t2 * t2)) * stretched;
  return normalize(vec3(alpha * n.xy, max(1e-6, n.z)));
}

vec3 sampleLobe(vec3 wo, vec3 u) {
  if (u.x < lobeSpecularShare) return reflect(-wo, sampleVisibleNormal(wo, lobeRoughness, u.yz));
  float r = sqrt(u.y);
  return vec3(r * cos(2.0 * pi * u.z), r * sin(2.0 * pi * u.z), sqrt(max(0.0, 1.0 - u.y)));
}

// Density of sampleLobe at wi, 1/sr.
float lobeDensity(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0) return 0.0;
  vec3 h = normalize(wi + wo);
  float alpha2 = lobeRoughness * lobeRoughness;
  float slope = dot(h.xy, h.xy) + alpha2 * h.z * h.z;
  float distribution = alpha2 / (pi * slope * slope);
  // G1(o) D / (4 cos o), with G1 / cos o folded into one fraction.
  float visible = distribution / (2.0 * (wo.z + sqrt(alpha2 + (1.0 - alpha2) * wo.z * wo.z)));
  return mix(wi.z / pi, visible, lobeSpecularShare);
}
