// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "app/goniotool/tool.h"

namespace gonio::tool {

struct ComponentArguments {
  std::string material, basis, out;
  int components = 0;
};

/// `goniotool encode --method components`: represents a material by principal components of a basis file (Nielsen et
/// al. 2015), and writes the material that they represent to `out`, unless it is empty. @throws Error if the basis has
/// fewer components.
int encodeComponents(const ComponentArguments& options, const Tool& tool);

}  // namespace gonio::tool
