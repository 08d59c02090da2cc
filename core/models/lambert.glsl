// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
INLINE vec3 formula_lambert(SurfaceGeometry g, vec3 kd) { return kd; }
