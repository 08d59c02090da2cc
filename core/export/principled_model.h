// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/surface_values.h"

namespace gonio::exports {

/// The Principled BSDF of Blender 3.4 in Cycles, distribution GGX (Burley 2012, "Physically-Based Shading at Disney",
/// with changes: the diffuse lobe with retro-reflection; GGX with the separable term of Walter et al. 2007 and a
/// Fresnel term that rises from F_0 (0.08 * specular for dielectrics) to 1 in the shape of the exact dielectric
/// formula; a GTR1 coat with the weight 0.25 * coat). No layer attenuates the one below. Reciprocal.
const SurfaceShader& principledShader();

}  // namespace gonio::exports
