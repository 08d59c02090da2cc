// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_target.h"
#include "core/export/surface_values.h"

namespace gonio::exports {

/// NAME.gltf: a sphere with the material of gltfShader(), its buffer embedded.
ExportTarget gltfTarget();

/// The document, UTF-8. Extensions are in it where they have an effect. @param origin in asset.extras.
std::string gltfDocument(const SurfaceValues& values, const std::string& name, const std::string& origin);

}  // namespace gonio::exports
