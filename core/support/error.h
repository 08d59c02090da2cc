// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace gonio {

/// The base class of the library's exceptions. Thrown for invalid user data; the derived class Cancelled is thrown
/// after a stop (catch Cancelled first where a stop is not an error). The message states the file (if any), what was
/// found, what was expected, and a hint. Code that knows more, such as the file name, may catch it and throw it again.
/// Finally the editor displays the message, and the command line prints it and returns an exit code. Programming errors
/// are `assert`s.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown by work that was stopped through its TaskControl and returns no partial result.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

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
