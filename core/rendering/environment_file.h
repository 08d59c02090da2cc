// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/rendering/environment.h"

namespace gonio {

/// A bundled environment by its name, or a latitude-longitude map from a file (HDR or EXR).
/// @param folder base of relative paths; empty: the current folder.
/// @throws Error that names the file and its fault, if it is neither.
std::shared_ptr<const EnvironmentMap> openEnvironment(const std::string& nameOrPath,
                                                      const std::filesystem::path& folder = {});

}  // namespace gonio
