// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/support/error.h"

namespace gonio::io {

/// The bytes are of another format, or a broken file of this one. Where no format takes a file, the error lists what
/// each of them found.
class FormatMismatch : public Error {
 public:
  using Error::Error;
  FormatMismatch(const std::string& found, const std::string& expected)
      : Error("found " + found + "; expected " + expected) {}
};

}  // namespace gonio::io
