// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "app/goniotool/tool.h"

namespace gonio::tool {

struct PatchArguments {
  std::string material, out;
  std::vector<std::string> train, excluded;
  std::size_t coefficients = 0;
};

/// `goniotool encode --method k-svd`: learns a dictionary of patches by K-SVD (dictionary::PatchDictionary), represents
/// a material by its code, and writes the decoded material to `out`, unless it is empty. @throws Error if a material
/// cannot be read or a training material has another grid than the first one.
int encodePatches(const PatchArguments& options, const Tool& tool);

}  // namespace gonio::tool
