// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Ray-casts the sphere and adds the radiance of `sampleCount` samples a pixel; alpha adds the coverage.
// Assembled by widgets/preview/shader_library: a variant holds only what its scene calls for.
//   LIGHT_ENVIRONMENT   environment light by multiple importance sampling (else one directional light)
//   SHOW_ENVIRONMENT    the environment behind the sphere
//   EDIT_MODEL          measured + strength (model(edited) - model(fitted)), with EVALUATE_MODEL and MODEL_PARAMETERS
//   EDIT_FACTORS        the table changed by its factor curves, before EDIT_MODEL; KEEP_DETAIL: by their difference
//   MODEL_ALONE         the model and no table, with EVALUATE_MODEL and MODEL_PARAMETERS
//   BLEND_TABLES        several tables mixed (preview/blend.glsl), and nothing else
// A file is put where it is first included: what several variants share comes before what only one has.
#include "half_difference.glsl"
#ifndef MODEL_ALONE
#include "preview/table.glsl"
#include "preview/data_transform.glsl"
#endif
#ifdef BLEND_TABLES
#include "preview/blend.glsl"
#endif
#ifdef EDIT_FACTORS
#include "preview/factors.glsl"
#endif
#ifdef LIGHT_ENVIRONMENT
#include "preview/environment.glsl"
#include "preview/sampling_lobe.glsl"
#endif

in vec2 position;
out vec4 accumulated;

const int maxSamples = 64;
uniform int sampleCount;
uniform vec4 sampleNumbers[maxSamples];  // three numbers for the lobe, the index of the light
uniform vec2 pixelOffsets[maxSamples];   // of the camera ray, in pixels about the centre
uniform vec2 pictureSize;

uniform vec3 eye;
uniform mat3 cameraAxes;    // columns: right, up, forward
uniform vec2 viewExtent;    // half size of the view at distance 1 (perspective), or in the world (orthographic)
uniform bool orthographic;

uniform vec3 toLight;
uniform vec3 irradiance;

#ifdef EDIT_MODEL
uniform vec3 editedParameters[MODEL_PARAMETERS];
uniform vec3 fittedParameters[MODEL_PARAMETERS];
uniform float editStrength;
#endif
#ifdef EDIT_FACTORS
uniform float factorStrength;
#endif
#ifdef MODEL_ALONE
uniform vec3 modelParameters[MODEL_PARAMETERS];
#endif

vec3 evaluateBrdf(vec3 wi, vec3 wo) {
  if (wi.z <= 0.0 || wo.z <= 0.0) return vec3(0.0);
#ifdef BLEND_TABLES
  return evaluateBlend(wi, wo);
#elif defined(MODEL_ALONE)
  return EVALUATE_MODEL(wi, wo, modelParameters);
#else
  bool valid;
  vec3 value = evaluateTable(wi, wo, valid);
#ifdef EDIT_FACTORS
  if (valid) {
    vec3 places = factorPlaces(wi, wo);
    float cosines = wi.z * wo.z;
    vec3 edited = evaluateFactors(places, cosines, 0);
#ifdef KEEP_DETAIL
    vec3 from = evaluateFactors(places, cosines, 1);
#else
    vec3 from = value;
#endif
    value = max(vec3(0.0), value + factorStrength * (edited - from));
  }
#endif
#ifdef EDIT_MODEL
  if (valid) {
    vec3 change = EVALUATE_MODEL(wi, wo, editedParameters) - EVALUATE_MODEL(wi, wo, fittedParameters);
    value = max(vec3(0.0), value + editStrength * change);
  }
#endif
  return value;
#endif
}

// PCG hash of a pixel (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
uvec3 pixelHash(uvec2 pixel) {
  uvec3 v = uvec3(pixel, 0x9E3779B9u) * 1664525u + 1013904223u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  return v;
}

bool hitSphere(vec3 origin, vec3 direction, out vec3 normal) {
  float b = dot(origin, direction);
  // The squared distance of the ray from the centre: no cancellation however far the eye is.
  vec3 nearest = origin - b * direction;
  float discriminant = 1.0 - dot(nearest, nearest);
  if (discriminant < 0.0) return false;
  normal = normalize(nearest - sqrt(discriminant) * direction);
  return true;
}

// Columns: tangent along growing azimuth about +y, bitangent, normal.
mat3 shadingFrame(vec3 n) {
  vec3 tangent = vec3(n.z, 0.0, -n.x);
  float squaredLength = dot(tangent, tangent);
  tangent = squaredLength > 1e-12 ? tangent * inversesqrt(squaredLength) : vec3(1.0, 0.0, 0.0);
  return mat3(tangent, cross(n, tangent), n);
}

#ifdef LIGHT_ENVIRONMENT
vec3 contribution(vec3 wi, vec3 wo, Light light) {
  if (wi.z <= 0.0) return vec3(0.0);
  // Balance heuristic with as many samples of either kind (Veach 1997): both weigh 1 / (sum of the densities).
  return evaluateBrdf(wi, wo) * light.radiance * (wi.z / (light.density + lobeDensity(wi, wo)));
}

vec3 reflected(mat3 frame, vec3 wo, vec4 numbers, uvec3 hash) {
  // Each pixel turns the shared numbers by its own amount: noise that fades, where bands would look like the material.
  vec3 rotation = vec3(hash >> 8u) / 16777216.0;
  Light light = drawnLight(int(numbers.w) + int(hash.x >> 16u));
  vec3 sum = contribution(light.direction * frame, wo, light);
  vec3 wi = sampleLobe(wo, fract(numbers.xyz + rotation));
  return sum + (wi.z > 0.0 ? contribution(wi, wo, environmentLight(frame * wi)) : vec3(0.0));
}
#else
vec3 reflected(mat3 frame, vec3 wo, vec4 numbers, uvec3 hash) {
  vec3 wi = toLight * frame;
  return wi.z > 0.0 ? evaluateBrdf(wi, wo) * irradiance * wi.z : vec3(0.0);
}
#endif

void main() {
  uvec3 hash = pixelHash(uvec2(gl_FragCoord.xy));
  vec4 sum = vec4(0.0);
  for (int i = 0; i < sampleCount; ++i) {
    vec2 at = ((position * pictureSize + pixelOffsets[i]) / pictureSize * 2.0 - 1.0) * viewExtent;
    vec3 origin = eye + (orthographic ? cameraAxes * vec3(at, 0.0) : vec3(0.0));
    vec3 direction = orthographic ? cameraAxes[2] : normalize(cameraAxes * vec3(at, 1.0));
    vec3 normal;
    if (hitSphere(origin, direction, normal)) {
      mat3 frame = shadingFrame(normal);
      sum += vec4(reflected(frame, -direction * frame, sampleNumbers[i], hash), 1.0);
    }
#ifdef SHOW_ENVIRONMENT
    else {
      sum += vec4(environmentRadiance(direction), 1.0);
    }
#endif
  }
  accumulated = sum;
}
