// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Mean of the accumulated samples, exposure, tone curve, sRGB: twin of core/rendering/tone_map.h. Uncovered parts show
// the background, a neutral display colour that exposure does not touch.
in vec2 position;
out vec4 displayed;

uniform sampler2D accumulation;
uniform float samples;
uniform float exposure;   // stops
uniform bool filmic;
uniform vec3 backgroundCentre;  // display sRGB
uniform vec3 backgroundEdge;

vec3 toSrgb(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

void main() {
  vec4 mean = texture(accumulation, position) / samples;
  float coverage = clamp(mean.a, 0.0, 1.0);
  vec3 radiance = max(vec3(0.0), mean.rgb / max(mean.a, 1e-6)) * exp2(exposure);
  vec3 c = clamp(radiance, 0.0, 1.0);
  // Narkowicz 2016, "ACES Filmic Tone Mapping Curve".
  if (filmic) {
    radiance = min(radiance, vec3(1e4));
    c = clamp(radiance * (2.51 * radiance + 0.03) / (radiance * (2.43 * radiance + 0.59) + 0.14), 0.0, 1.0);
  }
  vec3 background = mix(backgroundCentre, backgroundEdge, smoothstep(0.2, 0.75, length(position - 0.5)));
  displayed = vec4(mix(background, toSrgb(c), coverage), 1.0);
}
