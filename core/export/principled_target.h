// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// NAME_principled.py: a Python script that creates a Principled BSDF in Blender with the values fitted to
/// principledShader().
ExportTarget principledTarget();

/// The script, for Blender 3.4 and later; the formula is that of 3.4. @param origin text of the first lines.
std::string principledScript(const SurfaceValues& values, const std::string& name, const std::string& origin);

}  // namespace gonio::exports
