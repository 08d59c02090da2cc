// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/sampling/tabulated_density.h: a cosine part, half vectors drawn from the material's own values, tabulated for
// some viewers, and visible normals along the grain of an anisotropic material, or of a round highlight that serves in
// place of the table (core/sampling/fitted_densities.h).
#include "preview/marginal_warp.glsl"
#include "math.glsl"
#include "grain.glsl"
#include "anisotropic_ggx.glsl"

uniform sampler3D densityCells;
uniform sampler2D densityRows;
uniform float densityCosineFraction;  // 1 while the density is not known
uniform float densityGrainFraction;   // of all samples; 0 without a grain
uniform vec4 densityGrain;         // both widths, cosine and sine of the rotation

// The tabulated part's fraction of the samples; 0 if only rounding errors remain.
float densityTableFraction() {
  float fraction = 1.0 - densityCosineFraction - densityGrainFraction;
  return fraction > 1e-4 ? fraction : 0.0;
}

// Between which viewers one lies.
float densityViewer(float cosine) {
  const float lastCosine = 1.6e-3;
  float fraction = (1.0 - sqrt(clamp(cosine, lastCosine, 1.0))) / (1.0 - sqrt(lastCosine));
  return sqrt(fraction) * float(textureSize(densityCells, 0).z - 1);
}

vec2 densityAxis(vec3 wo) {
  float size = length(wo.xy);
  return size > 0.0 ? wo.xy / size : vec2(1.0, 0.0);
}

// The last index whose integral is not above the number sought, of a row of the cells (mixed with the next by `fraction`).
int densityColumn(int slice, int row, float fraction, float sought) {
  int low = 0;
  int high = textureSize(densityCells, 0).x - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    float integral = mix(texelFetch(densityCells, ivec3(middle, row, slice), 0).y,
                         texelFetch(densityCells, ivec3(middle, row + 1, slice), 0).y, fraction);
    if (integral <= sought) low = middle; else high = middle;
  }
  return low;
}

int densityRow(int slice, float sought) {
  int low = 0;
  int high = textureSize(densityRows, 0).x - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (texelFetch(densityRows, ivec2(middle, slice), 0).y <= sought) low = middle; else high = middle;
  }
  return low;
}

// A point of the square drawn from the density of one viewer.
vec2 sampledPoint(int slice, vec2 u) {
  int row = densityRow(slice, u.y);
  vec2 lowRow = texelFetch(densityRows, ivec2(row, slice), 0).xy;
  float highRow = texelFetch(densityRows, ivec2(row + 1, slice), 0).x;
  float y = inverseOfRamp(lowRow.x, highRow, u.y - lowRow.y);
  float sought = u.x * mix(lowRow.x, highRow, y);
  int column = densityColumn(slice, row, y, sought);
  vec2 left = mix(texelFetch(densityCells, ivec3(column, row, slice), 0).xy,
                  texelFetch(densityCells, ivec3(column, row + 1, slice), 0).xy, y);
  float right = mix(texelFetch(densityCells, ivec3(column + 1, row, slice), 0).x,
                    texelFetch(densityCells, ivec3(column + 1, row + 1, slice), 0).x, y);
  float x = inverseOfRamp(left.x, right, sought - left.y);
  return vec2(float(column) + x, float(row) + y) / vec2(textureSize(densityCells, 0).xy - 1);
}

// Heitz 2018, "Sampling the GGX Distribution of Visible Normals", section 3; in the frame of the grain.
vec3 sampleGrain(vec3 wo, vec2 u) {
  vec2 alpha = densityGrain.xy;
  vec3 stretched = normalize(vec3(alpha * wo.xy, wo.z));
  float across = length(stretched.xy);
  vec3 tangent = across > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) / across : vec3(1.0, 0.0, 0.0);
  vec3 bitangent = cross(stretched, tangent);
  float r = sqrt(u.x), phi = 2.0 * pi * u.y, s = 0.5 * (1.0 + stretched.z);
  float x = r * cos(phi);
  float y = (1.0 - s) * sqrt(1.0 - x * x) + s * r * sin(phi);
  vec3 n = x * tangent + y * bitangent + sqrt(max(0.0, 1.0 - x * x - y * y)) * stretched;
  return reflect(-wo, normalize(vec3(alpha * n.xy, max(0.0, n.z))));
}

float grainDensity(vec3 w, vec3 wo) {
  vec3 sum = w + wo;
  if (sum.z <= 0.0) return 0.0;
  return ggxDensity(normalize(sum), densityGrain.xy) / (4.0 * ggxCosineOverG1(wo, densityGrain.xy));
}

// A direction on the wrong side means that nothing was drawn.
vec3 sampleDensity(vec3 wo, vec3 u) {
  if (u.x < densityCosineFraction) {
    float r = sqrt(u.y);
    return vec3(r * cos(2.0 * pi * u.z), r * sin(2.0 * pi * u.z), sqrt(max(0.0, 1.0 - u.y)));
  }
  float before = densityCosineFraction + densityGrainFraction;
  if (u.x < before || (densityTableFraction() == 0.0 && densityGrainFraction > 0.0)) {
    vec3 wi = sampleGrain(inGrain(wo, densityGrain.zw), u.yz);
    // Half vectors seen from nearby the horizon reach below it: they are folded up, as in core/brdf/density_mixture.h.
    return inGrain(vec3(wi.xy, abs(wi.z)), vec2(densityGrain.z, -densityGrain.w));
  }
  // One of the two viewers about it is chosen: their densities blend all the same.
  float place = densityViewer(wo.z);
  float chosen = (u.x - before) / (1.0 - before);
  int slice = int(place) + (chosen < fract(place) ? 1 : 0);
  vec2 square = sampledPoint(min(slice, textureSize(densityCells, 0).z - 1), u.yz);
  float t = square.x * square.x * square.x * square.x;
  float phi = 2.0 * pi * square.y - pi;
  vec2 axis = densityAxis(wo);
  vec2 around = vec2(axis.x * cos(phi) - axis.y * sin(phi), axis.y * cos(phi) + axis.x * sin(phi));
  vec3 normal = vec3(2.0 * t * around, 1.0 - t * t) / (1.0 + t * t);
  return dot(wo, normal) > 0.0 ? reflect(-wo, normal) : vec3(0.0, 0.0, -1.0);
}

float tabulatedDensity(vec3 wi, vec3 wo) {
  vec3 normal = normalize(wi + wo);
  vec2 axis = densityAxis(wo);
  float phi = atan(axis.x * normal.y - axis.y * normal.x, dot(axis, normal.xy));
  // Nearer the pole, the half vector of two directions in single precision has no digits left, and the density would
  // vanish: it is that of the first cells all over them.
  const float nearestToPole = 0.016;
  float x = max(nearestToPole, sqrt(sqrt(length(normal.xy) / (1.0 + normal.z))));
  vec3 size = vec3(textureSize(densityCells, 0));
  vec2 place = vec2(x, (phi + pi) / (2.0 * pi)) * (size.xy - 1.0) + 0.5;
  float cells = texture(densityCells, vec3(place / size.xy, (densityViewer(wo.z) + 0.5) / size.z)).x;
  float x4 = x * x * x * x;
  float one = 1.0 + x4 * x4;
  float stretch = 32.0 * pi * x4 * x * x * x / (one * one);
  return cells * (size.x - 1.0) * (size.y - 1.0) / (stretch * 4.0 * max(dot(normal, wo), 1e-6));
}

// Density of sampleDensity at wi, 1/sr.
float samplingDensity(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0) return 0.0;
  float tableFraction = densityTableFraction();
  float density = densityCosineFraction * wi.z / pi;
  if (tableFraction > 0.0) density += tableFraction * tabulatedDensity(wi, wo);
  if (densityGrainFraction > 0.0) {
    vec3 light = inGrain(wi, densityGrain.zw), viewer = inGrain(wo, densityGrain.zw);
    density += densityGrainFraction * (grainDensity(light, viewer) + grainDensity(vec3(light.xy, -light.z), viewer));
  }
  return density;
}
