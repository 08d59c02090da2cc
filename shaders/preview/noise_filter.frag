// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// An edge-avoiding a-trous wavelet filter (Dammertz et al. 2010) that stops at normals and at differences beyond the
// noise (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering", without the temporal part). Passes, by
// widgets/preview/gl/noise_filter:
//   PREPARE  the mean of a pixel where it is covered, and the variance of that mean's luminance
//   LEVEL    a mean over the neighbours of a square lattice, `stride` being the way to one of them
//   else     back to premultiplied radiance with the coverage in alpha
// Between the passes radiance c is c / (1 + luminance): bright samples that few pixels have do not spread.
in vec2 position;
out vec4 result;

uniform sampler2D accumulation, features, filtered;
uniform float samples;
uniform bool hasFewSamples;  // then the variance is that among neighbours
uniform ivec2 stride;

const float normalPower = 64.0;
const float luminanceWidth = 4.0;  // in standard deviations of the noise
const float leastDeviation = 2e-3;
// Of the mean over n samples of a low-discrepancy sequence the variance falls faster than 1 / n: measured.
const float varianceExponent = 1.25;

float luminance(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }
ivec2 pixel() { return ivec2(gl_FragCoord.xy); }
ivec2 inside(sampler2D picture, ivec2 at) { return clamp(at, ivec2(0), textureSize(picture, 0) - 1); }

vec3 normalAt(ivec2 at) {
  vec3 sum = texelFetch(features, at, 0).xyz;
  float squared = dot(sum, sum);
  return squared > 0.0 ? sum * inversesqrt(squared) : vec3(0.0);
}

// What has no normal belongs together: the environment.
float normalWeight(vec3 a, vec3 b) {
  if (a == vec3(0.0) || b == vec3(0.0)) return a == b ? 1.0 : 0.0;
  return pow(max(0.0, dot(a, b)), normalPower);
}

#ifdef PREPARE
vec3 compressed(vec4 sum) {
  vec3 mean = sum.rgb / max(sum.a, 1e-6);
  return mean / (1.0 + luminance(mean));
}

float varianceOfSamples(ivec2 at) {
  vec4 sum = texelFetch(accumulation, at, 0);
  if (sum.a <= 0.0) return 0.0;
  float mean = luminance(sum.rgb) / sum.a;
  float variance = max(0.0, texelFetch(features, at, 0).w / sum.a - mean * mean) / pow(sum.a, varianceExponent);
  float slope = 1.0 / ((1.0 + mean) * (1.0 + mean));
  return variance * slope * slope;
}

void main() {
  vec4 sum = texelFetch(accumulation, pixel(), 0);
  vec3 colour = compressed(sum), normal = normalAt(pixel());
  int radius = hasFewSamples ? 2 : 1;
  float weights = 0.0, variances = 0.0, first = 0.0, second = 0.0;
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) {
      ivec2 at = inside(accumulation, pixel() + ivec2(x, y));
      vec4 other = texelFetch(accumulation, at, 0);
      float weight = other.a > 0.0 ? normalWeight(normal, normalAt(at)) : 0.0;
      weights += weight;
      if (hasFewSamples) {
        float l = luminance(compressed(other));
        first += weight * l;
        second += weight * l * l;
      } else {
        variances += weight * varianceOfSamples(at);
      }
    }
  weights = max(weights, 1e-6);
  float mean = first / weights;
  result = vec4(colour, hasFewSamples ? max(0.0, second / weights - mean * mean) : variances / weights);
}
#elif defined(LEVEL)
const float kernel[2] = float[](0.5, 0.25);

void main() {
  vec4 centre = texelFetch(filtered, pixel(), 0);
  if (texelFetch(accumulation, pixel(), 0).a <= 0.0) {
    result = centre;
    return;
  }
  vec3 normal = normalAt(pixel());
  float width = luminanceWidth * sqrt(centre.a) + leastDeviation, l = luminance(centre.rgb);
  vec4 sum = vec4(centre.rgb, centre.a) * vec4(vec3(kernel[0] * kernel[0]), kernel[0] * kernel[0] * kernel[0] * kernel[0]);
  float weights = kernel[0] * kernel[0];
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      if (x == 0 && y == 0) continue;
      ivec2 at = inside(filtered, pixel() + x * stride + y * ivec2(-stride.y, stride.x));
      if (texelFetch(accumulation, at, 0).a <= 0.0) continue;
      vec4 other = texelFetch(filtered, at, 0);
      float weight = kernel[abs(x)] * kernel[abs(y)] * normalWeight(normal, normalAt(at)) *
                     exp(-abs(luminance(other.rgb) - l) / width);
      sum += vec4(other.rgb * weight, other.a * weight * weight);
      weights += weight;
    }
  result = vec4(sum.rgb / weights, sum.a / (weights * weights));
}
#else
void main() {
  float coverage = texelFetch(accumulation, pixel(), 0).a / samples;
  vec3 colour = texelFetch(filtered, pixel(), 0).rgb;
  result = vec4(colour / max(1e-4, 1.0 - luminance(colour)) * coverage, coverage);
}
#endif
