// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/rendering/environment.h. `environment` holds radiance and, in alpha, the sampler's density (1/sr);
// `lightPool` holds directions drawn from that density on the CPU, in an order whose every run is well spread.
uniform sampler2D environment;
uniform sampler2D lightPool;
uniform float environmentRotation;

vec3 rotateAboutY(vec3 w, float angle) {
  float c = cos(angle);
  float s = sin(angle);
  return vec3(c * w.x - s * w.z, w.y, s * w.x + c * w.z);
}

vec2 environmentPosition(vec3 w) {
  return vec2(0.5 + atan(w.x, -w.z) / (2.0 * pi), acos(clamp(w.y, -1.0, 1.0)) / pi);
}

vec3 environmentRadiance(vec3 world) {
  return textureLod(environment, environmentPosition(rotateAboutY(world, -environmentRotation)), 0.0).rgb;
}

float environmentDensity(vec3 world) {
  vec2 at = environmentPosition(rotateAboutY(world, -environmentRotation));
  ivec2 size = textureSize(environment, 0);
  return texelFetch(environment, clamp(ivec2(at * vec2(size)), ivec2(0), size - 1), 0).a;
}

vec3 environmentSample(int index) {
  ivec2 size = textureSize(lightPool, 0);
  int wrapped = index % (size.x * size.y);
  return rotateAboutY(texelFetch(lightPool, ivec2(wrapped % size.x, wrapped / size.x), 0).xyz, environmentRotation);
}
