// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/support/error.h"

namespace gonio {

/// Runs work(); an Error of it is thrown again with the file's path before its text, Cancelled as it is.
template <typename Work>
auto namingFile(const std::filesystem::path& path, Work work) {
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    throw Error(path.string() + ": " + error.what());
  }
}

}  // namespace gonio
