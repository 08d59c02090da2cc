// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// x = 1 - cos theta_h, y = 1 - cos theta_d.
INLINE vec3 rationalValue(REAL x, REAL y, vec3 p0, vec3 px, vec3 py, vec3 pxx, vec3 pxy, vec3 pyy, REAL qx, REAL qy,
                          REAL qxx, REAL qxy, REAL qyy) {
  vec3 above = p0 + px * x + py * y + pxx * (x * x) + pxy * (x * y) + pyy * (y * y);
  REAL below = 1.0 + qx * x + qy * y + qxx * (x * x) + qxy * (x * y) + qyy * (y * y);
  return above / below;
}

INLINE vec3 formula_rational(SurfaceGeometry g, vec3 p0, vec3 px, vec3 py, vec3 pxx, vec3 pxy, vec3 pyy, REAL qx, REAL qy,
                             REAL qxx, REAL qxy, REAL qyy) {
  // wi - wo is 2 sin theta_d long: 1 - cos theta_d without cancellation.
  REAL y = 0.25 * dot(g.wi - g.wo, g.wi - g.wo) / (1.0 + g.cosD);
  return rationalValue(g.oneMinusCosH, y, p0, px, py, pxx, pxy, pyy, qx, qy, qxx, qxy, qyy);
}
