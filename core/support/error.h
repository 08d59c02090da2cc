// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <stdexcept>
#include <string>

namespace gonio {

/// The one exception base for bad user data. The text names the file (where there is one), what was found, what was
/// expected, and a hint. Caught once, at the edge: a dialog of the editor, the exit code of the command line.
/// Programmer errors are `assert`s instead.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown by work that was stopped through its TaskControl and has no partial result to return.
class Cancelled : public Error {
 public:
  Cancelled() : Error("cancelled") {}
};

}  // namespace gonio
