// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/surface_values.h"

namespace gonio::exports {

/// The material of glTF 2.0 (Khronos 2021, appendix B) with the extensions KHR_materials_specular, clearcoat, sheen and
/// anisotropy: a metal with Schlick's term, a dielectric of index 1.5 with a highlight that attenuates its diffuse
/// lobe, the sheen of Estévez and Kulla 2017 with the visibility term of Neubelt and Pettineo 2013, and a coat of index
/// 1.5. GGX with the height-correlated Smith term, single scattering. Not reciprocal with a coat.
const SurfaceShader& gltfShader();

}  // namespace gonio::exports
