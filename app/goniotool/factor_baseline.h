// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/goniotool/tool.h"

namespace gonio::tool {

struct FactorBaselineArguments {
  std::string material, method, out;
  std::size_t bytes = 0;  ///< budget
  int samples = 0;        ///< per pixel, in the pictures for the rendered SNR
};

/// The ids of all baselines, for --method.
std::vector<std::string> baselineIds();

/// goniotool factor --method METHOD with a baseline of the literature (core/baselines/baselines.h).
int factorByBaseline(const FactorBaselineArguments& options, const Tool& tool);

}  // namespace gonio::tool
