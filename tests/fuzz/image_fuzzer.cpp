// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/fuzz/reader_targets.h"

/// libFuzzer: start it with a folder of seeds, such as test-output/fuzz/seeds of the build.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  const bool isEncoded = size > 0 && (data[0] == 0x89 || data[0] == 0xff);  // as PNG and JPEG files begin
  try {
    (isEncoded ? gonio::fuzz::readEncodedImageBytes : gonio::fuzz::readImageBytes)(bytes);
  } catch (const gonio::Error&) {
  }
  return 0;
}
