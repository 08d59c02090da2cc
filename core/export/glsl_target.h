// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/reciprocal_lobes.h"

namespace gonio::exports {

/// NAME.glsl: a GLSL function of reciprocal lobes.
ExportTarget glslTarget();

/// The lobes as the function vec3 gonioBrdf(vec3 wi, vec3 wo) for GLSL 3.30 and GLSL ES 3.00. Its arguments are unit
/// vectors in the shading frame that point away from the surface; z is the normal, x the tangent. It returns linear
/// sRGB, 1/sr, without the cosine, 0 below the horizon. @param origin text of the first lines.
std::string glslFunction(const ReciprocalLobes& lobes, const std::string& origin);

}  // namespace gonio::exports
