// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdio>
#include <exception>

namespace gonio::study {

/// The exit code of a study: that of `run`, or 1 with the error told on the standard error output.
template <typename Run>
int studyMain(const Run& run) {
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace gonio::study
