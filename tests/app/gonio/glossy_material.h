// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/document/loaded_material.h"
#include "core/models/registry.h"
#include "tests/app/gonio/patience.h"

namespace gonio::app::test_support {

/// A GGX material as one that was read, without a file.
inline LoadedMaterialPtr glossyMaterial(double roughness, const HalfDifferenceGrid& grid = {}) {
  const models::Model& ggx = models::findModel("ggx");
  models::ParameterValues values = models::defaultParameters(ggx.spec());
  values.values[*ggx.spec().find("roughness")] = Rgb(roughness);
  values.values[*ggx.spec().find("specular")] = Rgb(0.9, 0.6, 0.3);
  auto loaded = std::make_shared<LoadedMaterial>();
  loaded->material.name = "glossy";
  loaded->base = bakeTable(*ggx.instantiate(values), grid);
  loaded->material.brdf = loaded->base;
  return loaded;
}

}  // namespace gonio::app::test_support
