// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/rendering/environment.h"

namespace gonio {

/// A bundled environment by its name, or a latitude-longitude picture (HDR or EXR) from disk, named by its path.
/// @param folder that a relative path starts from; empty: the current one.
/// @throws Error when it is neither, naming the file and what is wrong with it.
std::shared_ptr<const EnvironmentMap> openEnvironment(const std::string& nameOrPath,
                                                      const std::filesystem::path& folder = {});

}  // namespace gonio
