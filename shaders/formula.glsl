// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// The words that formulas (core/models/*.glsl) use: the twin of core/models/formula.h, in single precision.
#include "anisotropic_ggx.glsl"
#include "grain.glsl"
#include "math.glsl"

#define GLSL
#define REAL float
#define INLINE
#define OUT out

// Twin of core/models/surface_geometry.h.
struct SurfaceGeometry {
  vec3 wi, wo;
  vec3 h;  // unit half vector
  float cosI, cosO;
  float cosD;
  float sin2H;
  float oneMinusCosH;
};

// False where a BRDF is 0 by definition: a direction at or below the horizon, or wi = -wo.
bool surfaceGeometry(vec3 wi, vec3 wo, out SurfaceGeometry g) {
  const float horizonTolerance = 1e-12;
  vec3 sum = wi + wo;
  float squaredLength = dot(sum, sum);
  float sumLength = sqrt(squaredLength);
  g.wi = wi;
  g.wo = wo;
  g.h = squaredLength > 0.0 ? sum / sumLength : vec3(0.0, 0.0, 1.0);
  g.cosI = min(1.0, wi.z);
  g.cosO = min(1.0, wo.z);
  g.cosD = min(1.0, 0.5 * sumLength);
  g.sin2H = dot(g.h.xy, g.h.xy);
  g.oneMinusCosH = g.sin2H / (1.0 + g.h.z);
  return wi.z > horizonTolerance && wo.z > horizonTolerance && squaredLength >= 1e-24;
}

float logCosH(SurfaceGeometry g) { return g.oneMinusCosH < 0.5 ? logOnePlus(-g.oneMinusCosH) : log(g.h.z); }
