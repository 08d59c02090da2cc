// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>

#include "core/support/error.h"

namespace gonio::io {

/// A reader does not take the bytes: they are of another format, or a broken file of its own. The registry collects
/// these, so that a refused file tells what every reader saw.
class FormatMismatch : public Error {
 public:
  FormatMismatch(std::string foundText, std::string expectedText)
      : Error("found " + foundText + "; expected " + expectedText),
        found(std::move(foundText)),
        expected(std::move(expectedText)) {}

  std::string found, expected;
};

}  // namespace gonio::io
