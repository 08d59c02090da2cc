// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// p: diffuse, specular, beta, power, f0, sigma_s (nm), b (um), c, fresnel, edge tint, then ln D(0) with the mean
// slope and the mean square slope, then the 48 nodes of the masking.
#include "math.glsl"
#include "fresnel.glsl"
#include "surface_geometry.glsl"

const int PARAMETER_COUNT_HOLZSCHUCH_PACANOWSKI = 27;

float facetMaskingNode(int n, vec3 p[PARAMETER_COUNT_HOLZSCHUCH_PACANOWSKI]) {
  int node = clamp(n, 0, 47);
  return p[11 + node / 3][node % 3];
}

// Twin of ExponentialPowerDistribution::cosLambda().
float facetFoldedLambda(float cosTheta, float sinTheta, vec3 p[PARAMETER_COUNT_HOLZSCHUCH_PACANOWSKI]) {
  float slope = p[10].y * sinTheta, position = 47.0 * cosTheta / (cosTheta + 2.0 * slope);
  int left = min(int(position), 46);
  float t = position - float(left), t2 = t * t, t3 = t2 * t;
  vec4 weights = 0.5 * vec4(-t3 + 2.0 * t2 - t, 3.0 * t3 - 5.0 * t2 + 2.0, -3.0 * t3 + 4.0 * t2 + t, t3 - t2);
  return slope * dot(weights, vec4(facetMaskingNode(left - 1, p), facetMaskingNode(left, p),
                                   facetMaskingNode(left + 1, p), facetMaskingNode(left + 2, p)));
}

vec3 evaluate_holzschuch_pacanowski(vec3 wi, vec3 wo, vec3 p[PARAMETER_COUNT_HOLZSCHUCH_PACANOWSKI]) {
  SurfaceGeometry g;
  if (!surfaceGeometry(wi, wo, g)) return vec3(0.0);
  float cos2H = g.h.z * g.h.z, tilt = g.sin2H / (cos2H * p[2].x * p[2].x);
  float raised = tilt > 0.0 ? exp(min(80.0, p[3].x * log(tilt))) : 0.0;
  float density = exp(p[10].x - raised - 2.0 * log(cos2H));

  float lambdaI = facetFoldedLambda(g.cosI, length(wi.xy), p) * g.cosO;
  float lambdaO = facetFoldedLambda(g.cosO, length(wo.xy), p) * g.cosI;
  float along = dot(wi.xy, wo.xy), apart = acuteAngle(abs(wi.x * wo.y - wi.y * wo.x), abs(along));
  float phi = along < 0.0 ? pi - apart : apart;
  float correlation = 4.41 * phi / (4.41 * phi + 1.0);
  float masking = 1.0 / (g.cosI * g.cosO + max(lambdaI, lambdaO) + correlation * min(lambdaI, lambdaO));

  vec3 wavelengths = vec3(0.6114, 0.5491, 0.4643), ratio = wavelengths / p[6].x;
  vec3 root = 0.004 * pi * p[5].x * g.cosD / wavelengths;
  float c = p[7].x, strength = 2.0 * (c - 1.0) / pi, cos2D = g.cosD * g.cosD;
  vec3 lobes;
  for (int channel = 0; channel < 3; ++channel) {
    float phase = root[channel] * root[channel];
    float spread = ratio[channel] * ratio[channel], spreadOfBlur = spread / ((c + 1.0) * p[10].z);
    float v = 1.0 / (spread + cos2D * (2.0 * spread + cos2D * strength * exp(-p[10].x)) / (spreadOfBlur + cos2D));
    float flatness = spread * v;
    float projected = flatness * g.cosI * g.cosO + (1.0 - flatness) * cos2D * cos2H;
    float glow = strength * v * projected * exp(-0.5 * (c + 1.0) * logOnePlus(4.0 * v * cos2D * g.sin2H));
    lobes[channel] = exp(-phase) * density - expMinusOne(-phase) * glow;
  }
  return p[0] / pi + p[1] * lobes * (0.25 * fresnel(g.cosD, p[4].x, p[9].x, p[8].x) * masking);
}
