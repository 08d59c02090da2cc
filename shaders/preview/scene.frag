// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Ray-casts a scene of spheres, meshes and rectangles: adds the radiance of `sampleCount` samples a pixel; alpha adds the
// coverage. `features` are those of core/rendering/film.h. Twin of core/rendering/path_tracer.h. Assembled by widgets/preview/scene_uniforms and preview_renderer: a
// variant holds only what its scene calls for.
//   SPHERES, MESHES, RECTANGLES  how many objects of a kind
//   SEVERAL_MATERIALS    the pass draws what is seen of the materials in `drawnSlots`
//   DIFFUSE_OBJECTS      some are Lambertian, others are looked at
//   LIGHT_ENVIRONMENT    environment light by multiple importance sampling
//   SHOW_ENVIRONMENT     the environment behind the objects
//   DISTANT_LIGHTS, POINT_LIGHTS  how many
//   LAMPS                how many rectangles emit: the last ones
//   LIGHT_LAMPS          they light the objects
//   DRAW_LAMPS           by places drawn on them (else only drawn directions find them)
//   SHOW_LAMPS           the camera sees their fronts
//   SHADOWS              some object may stand in the light of another
//   INTERREFLECTION      light is followed over `reflections` of them (else one)
//   EDIT_STAGES          functions of the edits in their order, the last of which is LAST_STAGE, with EDIT_UNIFORMS
//                        (widgets/preview/gl/edit_chain); LOBE_EDITS where some are composed by lobes
//   FACTOR_EDITS         how many of them are of factor curves, and the base where it is factors (preview/factors.glsl)
//   FACTOR_BASE_TERMS, FACTOR_BASE_AXES  factors in place of the table, the first of these
//   RGL_THETAS, ...      an RGL file in place of the table (preview/rgl.glsl)
//   UTIA                 a UTIA material in place of the table (preview/utia.glsl)
//   INCIDENCE_TABLE, ... a table of angles of incidence (preview/incidence_table.glsl)
//   INCIDENT_VIEWER, INCIDENT_LIGHT  in which order they are read (preview/incident_direction.glsl)
//   MODEL_ALONE          a model in place of the table, with EVALUATE_MODEL, MODEL_UNIFORM and modelParameters
//   BLEND_TABLES         several tables mixed (preview/blend.glsl), with BLEND_OWN a part of one of them in its own form
#include "math.glsl"
#include "preview/material.glsl"
#include "preview/scene_shapes.glsl"
#if defined(LIGHT_ENVIRONMENT) || defined(LIGHT_LAMPS) || defined(INTERREFLECTION)
#define DRAW_DIRECTIONS
#if defined(SHADOWS) || defined(LIGHT_LAMPS) || defined(INTERREFLECTION)
#define MEET_OBJECTS
#endif
#include "preview/sampling_density.glsl"
#endif
#if defined(LIGHT_ENVIRONMENT) || defined(SHOW_ENVIRONMENT)
#include "preview/environment.glsl"
#endif

in vec2 position;
layout(location = 0) out vec4 accumulated;
layout(location = 1) out vec4 features;

const int maxSamples = 64;
uniform int sampleCount;
uniform vec4 sampleNumbers[maxSamples];  // three numbers for the density, the index of the sample
uniform vec2 pixelOffsets[maxSamples];   // of the camera ray, in pixels about the centre
uniform vec2 pictureSize;

uniform vec3 eye;
uniform mat3 cameraAxes;    // columns: right, up, forward
uniform vec2 viewExtent;    // half size of the view at distance 1 (perspective), or in the world (orthographic)
uniform bool orthographic;

#if DISTANT_LIGHTS > 0
uniform vec3 distantDirections[DISTANT_LIGHTS], distantIrradiances[DISTANT_LIGHTS];
#endif
#if POINT_LIGHTS > 0
uniform vec3 pointPositions[POINT_LIGHTS], pointIntensities[POINT_LIGHTS];
#endif

// The place of a pixel on Hilbert's curve through 256 x 256 of them.
uint hilbertIndex(uvec2 p) {
  uint index = 0u;
  p &= 255u;
  for (uint level = 128u; level > 0u; level >>= 1) {
    uint x = (p.x & level) != 0u ? 1u : 0u, y = (p.y & level) != 0u ? 1u : 0u;
    index += level * level * ((3u * x) ^ y);
    if (y == 0u) {
      if (x == 1u) p = 255u - p;
      p = p.yx;
    }
  }
  return index;
}

// PCG hash (Jarzynski and Olano 2020, "Hash Functions for GPU Rendering").
uvec3 hashed(uvec3 v) {
  v = v * 1664525u + 1013904223u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z; v.y += v.z * v.x; v.z += v.x * v.y;
  return v;
}

vec3 numbersOf(uvec3 hash) { return vec3(hash >> 8u) / 16777216.0; }

#ifdef INTERREFLECTION
uniform int reflections;
#else
const int reflections = 1;
#endif

#ifdef SEVERAL_MATERIALS
uniform int drawnSlots;  // bits; what has no slot, and the background, belong to slot 0

bool hasDrawnSlot(int object) { return ((drawnSlots >> int(objectColours[object].x)) & 1) != 0; }
bool drawsBackground() { return (drawnSlots & 1) != 0; }
bool isDrawn(int object) { return objectColours[object].w == materialSlot ? hasDrawnSlot(object) : drawsBackground(); }
// Whether light is followed that comes from there: that of another pass's material is not.
bool isKnown(int object) { return objectColours[object].w != materialSlot || hasDrawnSlot(object); }
#else
bool drawsBackground() { return true; }
bool isDrawn(int object) { return true; }
bool isKnown(int object) { return true; }
#endif

vec3 reflectance(Surface surface, vec3 wi) {
#ifdef DIFFUSE_OBJECTS
  vec4 colour = objectColours[surface.object];
  if (colour.w == diffuse) return surface.wo.z > 0.0 ? colour.rgb / pi : vec3(0.0);
#endif
  return evaluateBrdf(wi, surface.wo);
}

#ifdef DRAW_DIRECTIONS
bool isDiffuse(Surface surface) {
#ifdef DIFFUSE_OBJECTS
  return objectColours[surface.object].w == diffuse;
#else
  return false;
#endif
}

float drawnDensity(Surface surface, vec3 wi) {
  return isDiffuse(surface) ? max(0.0, wi.z) / pi : samplingDensity(wi, surface.wo);
}

vec3 drawDirection(Surface surface, vec3 u) {
  if (!isDiffuse(surface)) return sampleDensity(surface.wo, u);
  float r = sqrt(u.y);
  return vec3(r * cos(2.0 * pi * u.z), r * sin(2.0 * pi * u.z), sqrt(max(0.0, 1.0 - u.y)));
}
#endif

const int firstLamp = OBJECTS - LAMPS;

// The share of a direction that was drawn with a density, where another strategy finds it with the other density, over
// that density: the power heuristic (Veach 1997, section 9.2.4), as the reference renderer has it.
float weightOverDensity(float density, float other) {
  float ratio = other / density;
  return 1.0 / (density * (1.0 + ratio * ratio));
}

#ifdef LIGHT_LAMPS

// Density of a place drawn on the lamp, seen along a direction at a distance, 1/sr; 0 behind it.
float lampDensity(int lamp, vec3 direction, float t) {
  int i = lamp - firstRectangle;
  vec3 normal = cross(rectangleSides[2 * i], rectangleSides[2 * i + 1]);
  float cosineArea = -4.0 * dot(normal, direction);
  return cosineArea > 0.0 ? t * t / cosineArea : 0.0;
}

vec3 lampLight(Surface surface, int lamp, vec2 u) {
  int i = lamp - firstRectangle;
  vec3 place = rectangleCentres[i] + (2.0 * u.x - 1.0) * rectangleSides[2 * i] + (2.0 * u.y - 1.0) * rectangleSides[2 * i + 1];
  vec3 way = place - surface.position;
  float t = length(way);
  vec3 direction = way / t;
  vec3 wi = direction * surface.frame;
  float density = lampDensity(lamp, direction, t);
  if (!leaves(surface, direction, wi) || density <= 0.0 || isBlocked(surface, direction, t * 0.9999)) return vec3(0.0);
  return reflectance(surface, wi) * objectColours[lamp].rgb * (wi.z * weightOverDensity(density, drawnDensity(surface, wi)));
}
#endif

// Light of lamps without a size, and of places drawn on those that have one and in the environment. Where drawn
// directions find the same light, each counts for its share.
vec3 drawnLights(Surface surface, int index, uvec3 hash) {
  vec3 sum = vec3(0.0);
#if DISTANT_LIGHTS > 0
  for (int i = 0; i < DISTANT_LIGHTS; ++i) {
    vec3 wi = distantDirections[i] * surface.frame;
    if (leaves(surface, distantDirections[i], wi) && !isBlocked(surface, distantDirections[i], never))
      sum += reflectance(surface, wi) * distantIrradiances[i] * wi.z;
  }
#endif
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    vec3 way = pointPositions[i] - surface.position;
    float t = length(way);
    vec3 wi = (way / t) * surface.frame;
    if (leaves(surface, way, wi) && !isBlocked(surface, way / t, t))
      sum += reflectance(surface, wi) * pointIntensities[i] * (wi.z / (t * t));
  }
#endif
#ifdef DRAW_LAMPS
  for (int i = firstLamp; i < OBJECTS; ++i) sum += lampLight(surface, i, numbersOf(hashed(hash + uint(i))).xy);
#endif
#ifdef LIGHT_ENVIRONMENT
  Light light = drawnLight(index);
  vec3 wi = light.direction * surface.frame;
  if (leaves(surface, light.direction, wi) && !isBlocked(surface, light.direction, never))
    sum += reflectance(surface, wi) * light.radiance * (wi.z * weightOverDensity(light.density, drawnDensity(surface, wi)));
#endif
  return sum;
}

vec3 reflected(Surface surface, vec4 numbers, uint pixel, uvec3 hash) {
  vec3 sum = vec3(0.0);
#ifdef DRAW_DIRECTIONS
  vec3 throughput = vec3(1.0);
  // Each pixel turns the shared numbers by its own amount: noise that fades, where bands would look like the material.
  // The amounts follow a sequence along Hilbert's curve (that of Roberts 2018 in three dimensions), so that the errors of
  // neighbours cancel: an eighth to a fifth less noise is seen from afar than by amounts of chance.
  const uvec3 turn = uvec3(3518319153u, 2882110345u, 2360945575u);  // of 2^32
  const uint lightStride = 1150u;  // more than the samples of a pixel, whose lights neighbours must not share
  vec3 u = fract(numbers.xyz + vec3(turn * pixel >> 8u) / 16777216.0);
  int index = int(numbers.w) + int(lightStride * pixel & 0xFFFFu);
  hash.z += uint(numbers.w);
  for (int reflection = 1; reflection <= reflections; ++reflection) {
    hash = hashed(hash);
    if (surface.wo.z <= 0.0) break;
    sum += throughput * drawnLights(surface, index, hash);
    vec3 wi = drawDirection(surface, u);
    float density = drawnDensity(surface, wi);
    vec3 direction = surface.frame * wi;
    if (!leaves(surface, direction, wi) || density <= 0.0) break;
    vec3 value = throughput * reflectance(surface, wi) * wi.z;
#ifdef MEET_OBJECTS
    Hit hit = firstObject(surface.object, surface.position, direction);
#endif
#ifdef LIGHT_ENVIRONMENT
#ifdef SHADOWS
    bool open = hit.object < 0;
#else
    const bool open = true;
#endif
    if (open) {
      Light light = environmentLight(direction);
      sum += value * light.radiance * weightOverDensity(density, light.density);
    }
#endif
#ifdef MEET_OBJECTS
    if (hit.object < 0) break;
    if (hit.object >= firstLamp) {
#ifdef LIGHT_LAMPS
      float other = lampDensity(hit.object, direction, hit.t);
#ifdef DRAW_LAMPS
      if (other > 0.0) sum += value * objectColours[hit.object].rgb * weightOverDensity(density, other);
#else
      if (other > 0.0) sum += value * objectColours[hit.object].rgb / density;
#endif
#endif
      break;
    }
    if (!isKnown(hit.object)) break;
    throughput = value / density;
    uvec3 next = hashed(hash ^ 0x9E3779B9u);
    u = numbersOf(next);
    index = int(next.x >> 8u);
    if (reflection > 1) {
      float kept = min(0.95, max(throughput.r, max(throughput.g, throughput.b)));
      if (numbersOf(hashed(next)).x >= kept) break;
      throughput /= kept;
    }
    surface = surfaceAt(hit, surface.position, direction);
#endif
  }
#else
  if (surface.wo.z > 0.0) sum = drawnLights(surface, 0, hash);
#endif
  return sum;
}

void main() {
  uvec3 hash = hashed(uvec3(uvec2(gl_FragCoord.xy), 0x9E3779B9u));
  uint pixel = hilbertIndex(uvec2(gl_FragCoord.xy));
  vec4 sum = vec4(0.0);
  features = vec4(0.0);
  for (int i = 0; i < sampleCount; ++i) {
    vec2 at = ((position * pictureSize + pixelOffsets[i]) / pictureSize * 2.0 - 1.0) * viewExtent;
    vec3 origin = eye + (orthographic ? cameraAxes * vec3(at, 0.0) : vec3(0.0));
    vec3 direction = orthographic ? cameraAxes[2] : normalize(cameraAxes * vec3(at, 1.0));
    Hit hit = firstObject(-1, origin, direction);
    vec3 radiance = vec3(0.0), normal = vec3(0.0);
    if (hit.object >= firstLamp) {
      if (!drawsBackground()) continue;
#ifdef SHOW_LAMPS
      if (dot(objectNormal(hit.object, vec3(0.0)), direction) < 0.0) radiance = objectColours[hit.object].rgb;
#endif
    } else if (hit.object >= 0) {
      if (!isDrawn(hit.object)) continue;
      Surface surface = surfaceAt(hit, origin, direction);
      radiance = reflected(surface, sampleNumbers[i], pixel, hash);
      normal = surface.frame[2];
    } else {
#ifdef SHOW_ENVIRONMENT
      if (!drawsBackground()) continue;
      radiance = blurBackground ? blurredRadiance(direction) : environmentRadiance(direction);
#else
      continue;
#endif
    }
    sum += vec4(radiance, 1.0);
    float luminance = dot(radiance, vec3(0.2126, 0.7152, 0.0722));
    features += vec4(normal, luminance * luminance);
  }
  accumulated = sum;
}
