// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/reciprocal_lobes.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// NAME.mtlx: a sum of generalized_schlick_bsdf lobes.
ExportTarget materialXTarget();
/// NAME_openpbr.mtlx: open_pbr_surface.
ExportTarget openPbrTarget();
/// NAME_standard_surface.mtlx: standard_surface.
ExportTarget standardSurfaceTarget();

// MaterialX 1.39 documents, UTF-8, in linear sRGB (lin_rec709). The origin is in a comment.
std::string schlickLobesDocument(const ReciprocalLobes& lobes, const std::string& name, const std::string& origin);
std::string openPbrDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);
std::string standardSurfaceDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);

}  // namespace gonio::exports
