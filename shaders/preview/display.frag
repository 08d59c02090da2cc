// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Mean of the accumulated samples, exposure, tone curve, sRGB: twin of core/rendering/tone_map.h. Uncovered parts show
// the background, a neutral display colour that exposure does not touch.
// Assembled by widgets/preview/preview_display: with COMPARE a second picture, and
//   SPLIT       the first left of a place, the second right of it
//   TWO_UP      side by side
//   DIFFERENCE  the difference of the luminances in false colour: ABSOLUTE, SIGNED or RELATIVE to the second; twin of
//               widgets/preview/preview_comparison.h
in vec2 position;
out vec4 displayed;

uniform sampler2D accumulation;
uniform float samples;
uniform float exposure;   // stops
uniform bool filmic;
uniform vec3 backgroundCentre;  // display sRGB
uniform vec3 backgroundEdge;
uniform bool checker;
#ifdef COMPARE
uniform sampler2D otherAccumulation;
uniform float otherSamples;
#endif
#ifdef SPLIT
uniform float split;  // share of the width
#endif
#ifdef DIFFERENCE
uniform sampler2D colourMap;
uniform float range;  // the difference that has the last colour
const float smallestRelativeLuminance = 1e-3;
#endif

vec3 toSrgb(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

const float checkerPixels = 16.0;

vec3 background(vec2 at) {
  if (checker) {
    vec2 square = floor(gl_FragCoord.xy / checkerPixels);
    return vec3(mod(square.x + square.y, 2.0) < 0.5 ? 0.36 : 0.26);
  }
  return mix(backgroundCentre, backgroundEdge, smoothstep(0.2, 0.75, length(at - 0.5)));
}

// `mean` is premultiplied radiance with the coverage in alpha.
vec3 toDisplay(vec4 mean, vec2 at) {
  float coverage = clamp(mean.a, 0.0, 1.0);
  vec3 radiance = max(vec3(0.0), mean.rgb / max(mean.a, 1e-6)) * exp2(exposure);
  vec3 c = clamp(radiance, 0.0, 1.0);
  // Narkowicz 2016, "ACES Filmic Tone Mapping Curve".
  if (filmic) {
    radiance = min(radiance, vec3(1e4));
    c = clamp(radiance * (2.51 * radiance + 0.03) / (radiance * (2.43 * radiance + 0.59) + 0.14), 0.0, 1.0);
  }
  return mix(background(at), toSrgb(c), coverage);
}

#ifdef DIFFERENCE
vec3 falseColour(vec4 first, vec4 second, vec2 at) {
  const vec3 weights = vec3(0.2126, 0.7152, 0.0722);
  float l1 = dot(first.rgb, weights);
  float l2 = dot(second.rgb, weights);
#ifdef SIGNED
  float x = 0.5 + 0.5 * (l1 - l2) / range;
#elif defined(RELATIVE)
  float x = abs(l1 - l2) / max(l2, smallestRelativeLuminance) / range;
#else
  float x = abs(l1 - l2) / range;
#endif
  // Through the centres of the first and the last texel.
  float size = float(textureSize(colourMap, 0).x);
  vec3 colour = texture(colourMap, vec2((0.5 + clamp(x, 0.0, 1.0) * (size - 1.0)) / size, 0.5)).rgb;
  return mix(background(at), colour, clamp(max(first.a, second.a), 0.0, 1.0));
}
#endif

void main() {
  vec2 at = position;
#ifdef TWO_UP
  bool right = at.x >= 0.5;
  at.x = 2.0 * at.x - (right ? 1.0 : 0.0);
#endif
  vec4 mean = texture(accumulation, at) / samples;
#ifdef COMPARE
  vec4 other = texture(otherAccumulation, at) / otherSamples;
#endif
#ifdef DIFFERENCE
  displayed = vec4(falseColour(mean, other, at), 1.0);
#else
#ifdef SPLIT
  if (at.x >= split) mean = other;
#endif
#ifdef TWO_UP
  if (right) mean = other;
#endif
  displayed = vec4(toDisplay(mean, at), 1.0);
#endif
}
