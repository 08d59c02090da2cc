// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/models/ward_lobe.h, times exp(logFactor).
#include "math.glsl"
#include "surface_geometry.glsl"

float wardLobe(SurfaceGeometry g, float alphaX, float alphaY, float logFactor) {
  vec2 slope = g.h.xy / (vec2(alphaX, alphaY) * g.h.z);
  return exp(logFactor - dot(slope, slope)) / (4.0 * pi * alphaX * alphaY);
}
