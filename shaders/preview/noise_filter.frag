// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// An edge-avoiding a-trous wavelet filter (Dammertz et al. 2010) that stops at normals and at differences beyond the
// noise (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering", without the temporal part). Passes, by
// widgets/preview/gl/noise_filter:
//   PREPARE   the mean of a pixel, the normal, and the variance among the samples
//   VARIANCE  the variance of the mean's luminance
//   LEVEL     a mean over the neighbours of a square lattice, `stride` being the way to one of them
//   else      back to premultiplied radiance with the coverage in alpha
// Between the passes radiance c is c / (1 + luminance): bright samples that few pixels have do not spread.
// With CHANGE what is filtered is the change from one material to another, both drawn with the same random numbers at a
// lower resolution. The change is radiance, and the filter stops at normals only: most of it is in few samples, which a
// filter that stops at differences loses. Alpha is then the luminance of the first material, else the variance of the
// luminance. In place of VARIANCE and of the last pass:
//   OUTLIERS  what is far from all neighbours, by chance in one of the pictures, becomes like the last of them
//   ADD       adds the change to a picture of the first material, `known`, at its resolution
in vec2 position;
layout(location = 0) out vec4 result;
#ifdef PREPARE
layout(location = 1) out vec4 preparedGuide;
#endif

uniform sampler2D accumulation, features;  // the picture
uniform sampler2D filtered;                // the result of the pass before
uniform sampler2D guide;                   // the normal, and the variance among samples; below 0 where nothing is covered
uniform float samples;
#ifdef CHANGE
uniform sampler2D before, known, knownFeatures;
uniform float knownSamples;
#endif
uniform bool hasFewSamples;  // then the variance is that among neighbours
uniform ivec2 stride;

const float luminanceWidth = 4.0;  // in standard deviations of the noise
const float leastDeviation = 2e-3;
const float outlierWidth = 6.0;  // in standard deviations of the neighbours
// Of the mean over n samples of a low-discrepancy sequence the variance falls faster than 1 / n: measured.
const float varianceExponent = 1.25;

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }
ivec2 pixel() { return ivec2(gl_FragCoord.xy); }
ivec2 inside(ivec2 at) { return clamp(at, ivec2(0), textureSize(filtered, 0) - 1); }

vec3 compressed(vec4 sum) {
  vec3 mean = sum.rgb / max(sum.a, 1e-6);
  return mean / (1.0 + luminance(mean));
}

vec3 expanded(vec3 colour) { return colour / max(1e-4, 1.0 - luminance(colour)); }

vec4 guideOf(vec3 normals, float variance) {
  float squared = dot(normals, normals);
  return vec4(squared > 0.0 ? normals * inversesqrt(squared) : vec3(0.0), variance);
}

// Of two guides, 0 where nothing is covered. What has no normal belongs together: the environment.
float normalWeight(vec4 a, vec4 b) {
  if (b.w < 0.0) return 0.0;
  if (a.xyz == vec3(0.0) || b.xyz == vec3(0.0)) return a.xyz == b.xyz ? 1.0 : 0.0;
  // The cosine to the power of 64.
  float weight = max(0.0, dot(a.xyz, b.xyz));
  for (int i = 0; i < 6; ++i) weight *= weight;
  return weight;
}

#if defined(PREPARE)
float varianceOfSamples(vec4 sum, float squares) {
  float mean = luminance(sum.rgb) / sum.a;
  float variance = max(0.0, squares / sum.a - mean * mean) / pow(sum.a, varianceExponent);
  float slope = 1.0 / ((1.0 + mean) * (1.0 + mean));
  return variance * slope * slope;
}

void main() {
  vec4 sum = texelFetch(accumulation, pixel(), 0), feature = texelFetch(features, pixel(), 0);
#ifdef CHANGE
  vec3 first = texelFetch(before, pixel(), 0).rgb;
  result = vec4(sum.rgb - first, luminance(first)) / max(sum.a, 1e-6);
#else
  result = vec4(compressed(sum), 0.0);
#endif
  preparedGuide = guideOf(feature.xyz, sum.a > 0.0 ? varianceOfSamples(sum, feature.w) : -1.0);
}
#elif defined(VARIANCE)
void main() {
  vec4 own = texelFetch(guide, pixel(), 0);
  int radius = hasFewSamples ? 2 : 1;
  float weights = 0.0, variances = 0.0, first = 0.0, second = 0.0;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      ivec2 at = inside(pixel() + ivec2(x, y));
      vec4 other = texelFetch(guide, at, 0);
      float weight = normalWeight(own, other);
      weights += weight;
      if (hasFewSamples) {
        float l = luminance(texelFetch(filtered, at, 0).rgb);
        first += weight * l;
        second += weight * l * l;
      } else {
        variances += weight * other.w;
      }
    }
  weights = max(weights, 1e-6);
  float mean = first / weights;
  result = vec4(texelFetch(filtered, pixel(), 0).rgb,
                hasFewSamples ? max(0.0, second / weights - mean * mean) : variances / weights);
}
#elif defined(OUTLIERS)
void main() {
  result = texelFetch(filtered, pixel(), 0);
  vec4 own = texelFetch(guide, pixel(), 0);
  float weights = 0.0;
  vec3 first = vec3(0.0), second = vec3(0.0);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = inside(pixel() + ivec2(x, y));
      if (at == pixel()) continue;
      float weight = normalWeight(own, texelFetch(guide, at, 0));
      vec3 change = texelFetch(filtered, at, 0).rgb;
      weights += weight;
      first += weight * change;
      second += weight * change * change;
    }
  if (weights < 1.0) return;
  vec3 mean = first / weights, most = outlierWidth * sqrt(max(vec3(0.0), second / weights - mean * mean));
  result.rgb = clamp(result.rgb, mean - most, mean + most);
}
#elif defined(LEVEL)
const float kernel[2] = float[](0.5, 0.25);

void main() {
  vec4 centre = texelFetch(filtered, pixel(), 0), own = texelFetch(guide, pixel(), 0);
  if (own.w < 0.0) {
    result = centre;
    return;
  }
  float weights = kernel[0] * kernel[0];
#ifdef CHANGE
  vec4 sum = centre * weights;
#else
  float width = luminanceWidth * sqrt(centre.a) + leastDeviation, l = luminance(centre.rgb);
  vec4 sum = centre * vec4(vec3(weights), weights * weights);
#endif
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      ivec2 at = inside(pixel() + x * stride + y * ivec2(-stride.y, stride.x));
      vec4 other = texelFetch(filtered, at, 0);
      float weight = kernel[abs(x)] * kernel[abs(y)] * normalWeight(own, texelFetch(guide, at, 0));
#ifdef CHANGE
      sum += other * weight;
#else
      weight *= exp(-abs(luminance(other.rgb) - l) / width);
      sum += vec4(other.rgb * weight, other.a * weight * weight);
#endif
      weights += weight;
    }
#ifdef CHANGE
  result = sum / weights;
#else
  result = vec4(sum.rgb / weights, sum.a / (weights * weights));
#endif
}
#elif defined(ADD)
// The known radiance with its change. What becomes darker does so in the same ratio as its surroundings: the change is
// blurred, and beside a highlight that goes away it is larger than what is there.
vec3 changed(vec3 radiance, vec3 change, float luminanceAround) {
  float l = luminance(radiance), less = luminance(change);
  if (less >= 0.0 || l <= 0.0) return radiance + change;
  float share = min(1.0, l / max(luminanceAround, 1e-6));
  float ratio = max(0.0, 1.0 + less / max(luminanceAround, -less));
  return radiance * ratio + share * (change - radiance * (less / l));
}

// Linear interpolation among what is covered and has about the normal of the pixel.
vec4 changeAt(vec4 own) {
  vec2 place = position * vec2(textureSize(filtered, 0)) - 0.5, corner = floor(place), part = place - corner;
  vec4 sum = vec4(0.0);
  float weights = 1e-9;
  for (int i = 0; i < 4; ++i) {
    vec2 step = vec2(i & 1, i >> 1), near = mix(1.0 - part, part, step);
    ivec2 at = inside(ivec2(corner + step));
    vec4 other = texelFetch(guide, at, 0);
    float weight = other.w < 0.0 ? 0.0 : near.x * near.y * (1e-4 + normalWeight(own, other));
    sum += weight * texelFetch(filtered, at, 0);
    weights += weight;
  }
  return sum / weights;
}

void main() {
  vec4 sum = texelFetch(known, pixel(), 0), feature = texelFetch(knownFeatures, pixel(), 0);
  vec4 change = changeAt(guideOf(feature.xyz, 0.0));
  float coverage = sum.a / knownSamples;
  result = vec4(max(vec3(0.0), changed(sum.rgb / max(sum.a, 1e-6), change.rgb, change.a)) * coverage, coverage);
}
#else
void main() {
  float coverage = texelFetch(accumulation, pixel(), 0).a / samples;
  result = vec4(expanded(texelFetch(filtered, pixel(), 0).rgb) * coverage, coverage);
}
#endif
