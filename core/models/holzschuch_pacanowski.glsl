// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of holzschuch_pacanowski.cpp.
#include "core/models/fresnel.glsl"

float facetMaskingNode(int n, vec3 nodes[16]) {
  int node = clamp(n, 0, 47);
  return nodes[node / 3][node % 3];
}

// Twin of ExponentialPowerDistribution::cosLambda().
float facetFoldedLambda(float cosTheta, float sinTheta, float meanSlope, vec3 nodes[16]) {
  float slope = meanSlope * sinTheta, position = 47.0 * cosTheta / (cosTheta + 2.0 * slope);
  int left = min(int(position), 46);
  float t = position - float(left), t2 = t * t, t3 = t2 * t;
  vec4 weights = 0.5 * vec4(-t3 + 2.0 * t2 - t, 3.0 * t3 - 5.0 * t2 + 2.0, -3.0 * t3 + 4.0 * t2 + t, t3 - t2);
  return slope * dot(weights, vec4(facetMaskingNode(left - 1, nodes), facetMaskingNode(left, nodes),
                                   facetMaskingNode(left + 1, nodes), facetMaskingNode(left + 2, nodes)));
}

// slopes: ln D(0), the mean slope, the mean square slope. nodes: of the masking, three an entry. nanoRoughness in nm,
// correlation in um.
vec3 formula_holzschuch_pacanowski(SurfaceGeometry g, vec3 kd, vec3 ks, float beta, float power, float nanoRoughness,
                                   float correlationLength, float c, FresnelTerm term, vec3 slopes, vec3 nodes[16]) {
  float cos2H = g.h.z * g.h.z, tilt = g.sin2H / (cos2H * beta * beta);
  float raised = tilt > 0.0 ? exp(min(80.0, power * log(tilt))) : 0.0;
  float density = exp(slopes.x - raised - 2.0 * log(cos2H));

  float lambdaI = facetFoldedLambda(g.cosI, length(g.wi.xy), slopes.y, nodes) * g.cosO;
  float lambdaO = facetFoldedLambda(g.cosO, length(g.wo.xy), slopes.y, nodes) * g.cosI;
  float along = dot(g.wi.xy, g.wo.xy), apart = acuteAngle(abs(g.wi.x * g.wo.y - g.wi.y * g.wo.x), abs(along));
  float phi = along < 0.0 ? pi - apart : apart;
  float correlation = 4.41 * phi / (4.41 * phi + 1.0);
  float masking = 1.0 / (g.cosI * g.cosO + max(lambdaI, lambdaO) + correlation * min(lambdaI, lambdaO));

  vec3 wavelengths = vec3(0.6114, 0.5491, 0.4643), ratio = wavelengths / correlationLength;
  vec3 root = 0.004 * pi * nanoRoughness * g.cosD / wavelengths;
  float strength = 2.0 * (c - 1.0) / pi, cos2D = g.cosD * g.cosD;
  vec3 lobes;
  for (int channel = 0; channel < 3; ++channel) {
    float phase = root[channel] * root[channel];
    float spread = ratio[channel] * ratio[channel], spreadOfBlur = spread / ((c + 1.0) * slopes.z);
    float v = 1.0 / (spread + cos2D * (2.0 * spread + cos2D * strength * exp(-slopes.x)) / (spreadOfBlur + cos2D));
    float flatness = spread * v;
    float projected = flatness * g.cosI * g.cosO + (1.0 - flatness) * cos2D * cos2H;
    float glow = strength * v * projected * exp(-0.5 * (c + 1.0) * logOnePlus(4.0 * v * cos2D * g.sin2H));
    lobes[channel] = exp(-phase) * density - expMinusOne(-phase) * glow;
  }
  return kd + ks * lobes * (0.25 * fresnel(term, g.cosD) * masking);
}
