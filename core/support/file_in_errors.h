// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/support/error.h"

namespace gonio {

/// Runs work() and prepends the file's path to the message of any Error that it throws. The new exception is a plain
/// Error; Cancelled is passed on.
template <typename Work>
auto withFileInErrors(const std::filesystem::path& path, Work work) {
  try {
    return work();
  } catch (const Cancelled&) {
    throw;
  } catch (const Error& error) {
    // Messages end at a NUL character, which a path from a document may have.
    throw Error(std::string(path.c_str()) + ": " + error.what());
  }
}

}  // namespace gonio
