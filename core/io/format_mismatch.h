// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string>

#include "core/support/error.h"

namespace gonio::io {

/// The bytes are in another format, or a damaged file of this format. If no reader accepts a file, the final error
/// lists what each of them found.
class FormatMismatch : public Error {
 public:
  using Error::Error;
  FormatMismatch(const std::string& found, const std::string& expected)
      : Error("found " + found + "; expected " + expected) {}

  /// For a file that has the format but ends too early.
  static FormatMismatch truncated(const std::string& found, const std::string& expected, std::uint64_t bytes,
                                  std::uint64_t wholeBytes) {
    FormatMismatch mismatch(found, expected);
    mismatch.verdict_ = "the file is truncated: " + std::to_string(bytes) + " bytes of " + std::to_string(wholeBytes);
    return mismatch;
  }
  /// A short explanation if the file has this format nevertheless; otherwise empty.
  const std::string& verdict() const { return verdict_; }

 private:
  std::string verdict_;
};

}  // namespace gonio::io
