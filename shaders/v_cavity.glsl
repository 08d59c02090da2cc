// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
// Twin of core/models/v_cavity.h: G / (cos theta_i cos theta_o).
#include "surface_geometry.glsl"

float vCavityOverCosines(SurfaceGeometry g) {
  return min(1.0 / (g.cosI * g.cosO), 2.0 * g.h.z / (g.cosD * max(g.cosI, g.cosO)));
}
