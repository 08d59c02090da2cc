// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/rendering/environment.h. `environment` holds radiance and, in alpha, the sampler's density (1/sr).
// `lightPool` holds directions drawn from that density on the CPU, with the density in alpha, in an order whose every run
// is well spread; `lightPoolRadiance` holds their radiance: a draw costs two fetches and no trigonometry. Below them stands
// the blurred environment (core/rendering/blurred_environment.h), row after row.
#include "math.glsl"

uniform sampler2D environment;
uniform sampler2D lightPool;
uniform sampler2D lightPoolRadiance;
uniform vec2 environmentTurn;  // cosine and sine of the environment's rotation

struct Light {
  vec3 direction;  // world
  vec3 radiance;
  float density;   // of the environment's sampler there, 1/sr
};

vec2 environmentPosition(vec3 world) {
  vec3 w = vec3(world.x * environmentTurn.x + world.z * environmentTurn.y, world.y,
                world.z * environmentTurn.x - world.x * environmentTurn.y);
  return vec2(0.5 + atan(w.x, -w.z) / (2.0 * pi), acos(clamp(w.y, -1.0, 1.0)) / pi);
}

#ifdef SHOW_ENVIRONMENT
uniform bool blurBackground;
const ivec2 blurredSize = ivec2(128, 64);

vec3 blurredTexel(ivec2 at) {
  ivec2 inside = ivec2((at.x + blurredSize.x) % blurredSize.x, clamp(at.y, 0, blurredSize.y - 1));
  int index = inside.y * blurredSize.x + inside.x;
  ivec2 pool = textureSize(lightPool, 0);
  return texelFetch(lightPoolRadiance, ivec2(index % pool.x, pool.y + index / pool.x), 0).rgb;
}

vec3 blurredRadiance(vec3 world) {
  vec2 at = environmentPosition(world) * vec2(blurredSize) - 0.5;
  ivec2 low = ivec2(floor(at));
  vec2 fraction = at - vec2(low);
  return mix(mix(blurredTexel(low), blurredTexel(low + ivec2(1, 0)), fraction.x),
             mix(blurredTexel(low + ivec2(0, 1)), blurredTexel(low + ivec2(1, 1)), fraction.x), fraction.y);
}
#endif

vec3 environmentRadiance(vec3 world) { return textureLod(environment, environmentPosition(world), 0.0).rgb; }

Light environmentLight(vec3 world) {
  vec4 found = textureLod(environment, environmentPosition(world), 0.0);
  return Light(world, found.rgb, found.a);
}

Light drawnLight(int index) {
  ivec2 size = textureSize(lightPool, 0);
  int wrapped = index % (size.x * size.y);
  ivec2 at = ivec2(wrapped % size.x, wrapped / size.x);
  vec4 drawn = texelFetch(lightPool, at, 0);
  vec3 world = vec3(drawn.x * environmentTurn.x - drawn.z * environmentTurn.y, drawn.y,
                    drawn.z * environmentTurn.x + drawn.x * environmentTurn.y);
  return Light(world, texelFetch(lightPoolRadiance, at, 0).rgb, drawn.a);
}
