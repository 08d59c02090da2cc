// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of inverseTransformed() in core/brdf/data_transform.h: the reflectance, 1/sr, of transformed values >= 0; at most
// the largest float.
// `transform` is a DataTransform; `cosines` that of the two directions, multiplied.
#include "math.glsl"

const float maxBrdfValue = 3.4028234e38;

vec3 inverseTransformed(int transform, vec3 y, float cosines) {
  if (transform <= 1 || transform == 4 || transform == 5) {
    y = min(y, vec3(88.0));  // e^88 is the last round exponent in the range of float
    vec3 value = vec3(expMinusOne(y.r), expMinusOne(y.g), expMinusOne(y.b));
    if (transform == 1) return min(value / max(cosines, 1e-3), vec3(maxBrdfValue));
    return (transform == 4 ? 0.1 : transform == 5 ? 0.01 : 1.0) * value;
  }
  if (transform == 3) return y;
  vec3 power = transform == 2 ? y * y : transform == 6 ? y * sqrt(y) : transform == 7 ? y * y * sqrt(y) : y * y * y;
  return min(power, vec3(maxBrdfValue));
}
