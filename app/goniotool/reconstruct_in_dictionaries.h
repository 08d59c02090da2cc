// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <vector>

#include "app/goniotool/tool.h"

namespace gonio::tool {

/// Name of this method, in addition to reconstructionMethodNames.
inline constexpr const char* dictionariesMethod = "dictionaries";

struct DictionaryReconstructionRequest {
  std::string plan, values, out;
  std::string dictionary;  ///< a .dictionary file; empty: the bundled one
  std::vector<std::string> train, excluded;
};

/// `goniotool reconstruct --method dictionaries`: learns the prior, reconstructs, writes the material and reports.
int reconstructWithDictionaries(const DictionaryReconstructionRequest& request, const Tool& tool);

}  // namespace gonio::tool
