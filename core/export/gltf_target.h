// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// NAME.gltf: a sphere with the material of gltfShader() and an embedded buffer.
ExportTarget gltfTarget();

/// The document, UTF-8. Contains only extensions that have an effect. @param origin text of asset.extras.
std::string gltfDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);

}  // namespace gonio::exports
