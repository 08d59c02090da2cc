// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/rendering/environment_file.h"

#include "core/io/image_io.h"
#include "core/support/error.h"

namespace gonio {

std::shared_ptr<const EnvironmentMap> openEnvironment(const std::string& nameOrPath,
                                                      const std::filesystem::path& folder) {
  for (const std::string& bundled : bundledEnvironmentNames())
    if (nameOrPath == bundled) return bundledEnvironment(nameOrPath);
  const std::filesystem::path path = folder / nameOrPath;
  if (std::error_code unreadable; !std::filesystem::exists(path, unreadable))
    throw Error(path.string() + ": found neither a bundled environment (" + bundledEnvironmentList() +
                ") nor a file with this name");
  // A map's errors name it, by its path here.
  return std::make_shared<const EnvironmentMap>(io::readImage(path), path.string());
}

}  // namespace gonio
