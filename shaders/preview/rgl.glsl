// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/rgl_brdf.h: an RGL file in its adaptive parameterisation.
//   RGL_THETAS, RGL_PHIS   how many polar angles and azimuths of incidence
//   RGL_ANISOTROPIC        azimuths count; else they are relative to the incident one
//   RGL_REDUCTION          how many times the azimuths of incidence cover the circle
//   RGL_JACOBIAN           the colours are divided by ndf / (4 sigma)
#include "preview/incident_direction.glsl"
#include "preview/marginal_warp.glsl"
#include "preview/normal_square.glsl"

uniform sampler3D rglNormals, rglColours;
uniform sampler2D rglRows, rglDistribution, rglArea;
uniform float rglThetas[RGL_THETAS];
uniform float rglPhis[RGL_PHIS];

Slices rglSlices(float phi, float theta) {
  float across = 0.0;
  for (int i = 0; i < RGL_THETAS - 1; ++i)
    across += clamp((theta - rglThetas[i]) / (rglThetas[i + 1] - rglThetas[i]), 0.0, 1.0);
  float around = 0.0;
  for (int i = 0; i < RGL_PHIS - 1; ++i)
    around += clamp((phi - rglPhis[i]) / (rglPhis[i + 1] - rglPhis[i]), 0.0, 1.0);
  const float count = float(RGL_THETAS * RGL_PHIS);
  float low = floor(around);
  float high = min(low + 1.0, float(RGL_PHIS - 1));
  return Slices((low * float(RGL_THETAS) + across + 0.5) / count, (high * float(RGL_THETAS) + across + 0.5) / count, around - low);
}

vec4 rglBilinear(sampler2D values, vec2 point) {
  vec2 size = vec2(textureSize(values, 0));
  return texture(values, (clamp(point, 0.0, 1.0) * (size - 1.0) + 0.5) / size);
}

vec3 rglColour(vec2 point, Slices at) {
  vec2 size = vec2(textureSize(rglColours, 0).xy);
  vec2 place = (point * (size - 1.0) + 0.5) / size;
  vec3 value = texture(rglColours, vec3(place, at.low)).rgb;
  if (at.fraction > 0.0) value = mix(value, texture(rglColours, vec3(place, at.high)).rgb, at.fraction);
  return value;
}

vec3 storedBrdf(vec3 incident, vec3 outgoing) {
#if RGL_REDUCTION >= 2
  float flipY = incident.y < 0.0 ? 1.0 : -1.0;
#if RGL_REDUCTION == 4
  float flipX = incident.x < 0.0 ? 1.0 : -1.0;
#else
  float flipX = flipY;
#endif
  incident.xy *= vec2(flipX, flipY);
  outgoing.xy *= vec2(flipX, flipY);
#endif
  float phi = azimuthOf(incident);
#ifdef RGL_ANISOTROPIC
  const float turn = 0.0;
#else
  float turn = phi;
#endif
  vec2 incidentSquare = toNormalSquare(incident, 0.0);
  vec2 normal = toNormalSquare(normalize(incident + outgoing), turn);
  Slices at = rglSlices(phi, incidentSquare.x * incidentSquare.x * (0.5 * pi));
  float density;
  vec3 value = rglColour(warpInverse(rglNormals, rglRows, normal, at, density), at);
#ifdef RGL_JACOBIAN
  float area = rglBilinear(rglArea, incidentSquare).x;
  if (area <= 0.0) return vec3(0.0);
  value *= rglBilinear(rglDistribution, normal).x / (4.0 * area);
#endif
  return value / max(outgoing.z, 1e-3);
}
