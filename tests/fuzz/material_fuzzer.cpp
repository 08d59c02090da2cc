// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/bundled_basis.h"
#include "tests/fuzz/reader_targets.h"

/// Files of points need a basis, which takes longer to learn than one input may take.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  gonio::materials::bundledBasis();
  return 0;
}

/// libFuzzer: start it with a folder of seeds, such as test-output/fuzz/seeds of the build.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  try {
    gonio::fuzz::readMaterialBytes(std::as_bytes(std::span(data, size)));
  } catch (const gonio::Error&) {
  }
  return 0;
}
