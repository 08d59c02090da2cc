// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
// Twin of inverseTransformed() in core/brdf/data_transform.h: the reflectance, 1/sr, of transformed values >= 0.
// `transform` is a DataTransform; `cosines` that of the two directions, multiplied.
#include "math.glsl"

vec3 inverseTransformed(int transform, vec3 y, float cosines) {
  if (transform <= 1) {
    vec3 value = vec3(expMinusOne(y.r), expMinusOne(y.g), expMinusOne(y.b));
    return transform == 0 ? value : value / max(cosines, 1e-3);
  }
  return transform == 2 ? y * y : y;
}
