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

/// The principal components of the materials of study::trainingFilesOrLibrary(). @param seconds receives the time of
/// reading and learning.
std::shared_ptr<const materials::BasisFile> learnBasis(const std::vector<std::string>& sources,
                                                       const std::vector<std::string>& excluded, int maxComponents,
                                                       const Tool& tool, double& seconds);

/// The help of an option that names training materials, e.g. "Training set: .binary, .bsdf or .bin files, or folders of
/// them"; `title` is the part before the colon.
std::string trainingSetHelp(const std::string& title);

/// Path of a plan's basis, beside the plan: PLAN.basis for PLAN.csv.
std::filesystem::path basisBeside(const std::string& plan);

/// Identifies the basis in a plan: the first 16 characters of the file's SHA-256. @throws Error that names the file.
std::string basisDigest(const std::filesystem::path& basis);

}  // namespace gonio::tool
