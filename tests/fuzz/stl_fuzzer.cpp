// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/fuzz/reader_targets.h"

/// libFuzzer: start it with a folder of seeds, such as test-output/fuzz/seeds of the build.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    gonio::fuzz::readStlBytes(std::as_bytes(std::span(data, size)));
  } catch (const gonio::Error&) {
  }
  return 0;
}
