// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/goniotool/tool.h"
#include "core/materials/basis_file.h"

namespace gonio::tool {

/// The principal components of materials as trainingFiles() finds them; of none, of the bundled library.
/// @param seconds how long the learning took, reading included.
std::shared_ptr<const materials::BasisFile> learnBasis(const std::vector<std::string>& sources,
                                                       const std::vector<std::string>& excluded, int maxComponents,
                                                       const Tool& tool, double& seconds);

/// Where the basis of a plan lies: beside it, PLAN.csv has PLAN.basis.
std::filesystem::path basisBeside(const std::string& plan);

/// By which a plan knows its basis: the first 16 characters of the SHA-256 of the file. @throws Error naming the file.
std::string basisDigest(const std::filesystem::path& basis);

}  // namespace gonio::tool
