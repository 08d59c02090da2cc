// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of inverseTransformed() in core/brdf/data_transform.h: the reflectance, 1/sr, of transformed values >= 0; at most
// the largest float.
// `transform` is a DataTransform; `cosines` that of the two directions, multiplied.
#include "math.glsl"

const float maxBrdfValue = 3.4028234e38;

vec3 inverseTransformed(int transform, vec3 y, float cosines) {
  if (transform <= 1) {
    y = min(y, vec3(88.0));  // e^88 is the last round exponent in the range of float
    vec3 value = vec3(expMinusOne(y.r), expMinusOne(y.g), expMinusOne(y.b));
    return transform == 0 ? value : min(value / max(cosines, 1e-3), vec3(maxBrdfValue));
  }
  return transform == 2 ? min(y * y, vec3(maxBrdfValue)) : y;
}
