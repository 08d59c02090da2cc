// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/brdf/normal_square.h: the unit square of half vectors.
#include "math.glsl"

vec2 toNormalSquare(vec3 half_, float turn) {
  float y = (atan(half_.y, half_.x) - turn + pi) / (2.0 * pi);
  return vec2(sqrt(acuteAngle(length(half_.xy), half_.z) * (2.0 / pi)), fract(y));
}

vec3 fromNormalSquare(vec2 square, float turn) {
  float theta = square.x * square.x * (0.5 * pi);
  float phi = 2.0 * pi * square.y - pi + turn;
  return vec3(sin(theta) * vec2(cos(phi), sin(phi)), cos(theta));
}

// Area of the square that a solid angle of reflected directions covers, 1/sr. `half_` is a unit vector.
float squarePerSolidAngle(vec2 square, vec3 half_, vec3 w) {
  float stretch = 2.0 * pi * pi * square.x * length(half_.xy);
  return 1.0 / (max(stretch, 1e-10) * 4.0 * max(dot(half_, w), 1e-6));
}

float azimuthOf(vec3 w) { return w.x == 0.0 && w.y == 0.0 ? 0.0 : atan(w.y, w.x); }
