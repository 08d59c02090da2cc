// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>

#include "core/formats/formats.h"
#include "tests/fuzz/reader_targets.h"

namespace {

/// Files of individual directions are left to the fuzzer `scattered`: the reconstruction of a table from one of them
/// takes longer than thousands of other inputs.
bool isReconstructed(std::span<const std::byte> bytes) {
  namespace formats = gonio::formats;
  const auto* format = &gonio::materials::sniffFormat(gonio::io::MemorySource(bytes));
  return std::ranges::count(std::array{&formats::astmFormat, &formats::goniophotometerFormat, &formats::refletFormat,
                                       &formats::altaFormat, &formats::curetFormat, &formats::openMaterialFormat,
                                       &formats::speosFormat, &formats::csvFormat},
                            format) > 0;
}

}  // namespace

/// libFuzzer: start it with a folder of seeds, such as test-output/fuzz/seeds of the build.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  try {
    if (!isReconstructed(bytes)) gonio::fuzz::readMaterialBytes(bytes);
  } catch (const gonio::Error&) {
  }
  return 0;
}
