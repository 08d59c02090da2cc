// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>

#include "core/formats/formats.h"
#include "tests/fuzz/reader_targets.h"

#ifndef GONIO_FUZZED_FORMAT
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
#endif

/// libFuzzer: start it with a folder of seeds, such as test-output/fuzz/seeds of the build. Compiled once for all
/// formats, and again for some of them alone (GONIO_FUZZED_FORMAT), whose readers then get every input.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  try {
#ifdef GONIO_FUZZED_FORMAT
    gonio::materials::Material material;
    gonio::formats::GONIO_FUZZED_FORMAT.read(gonio::io::MemorySource(bytes), {}, material);
    gonio::fuzz::checkValues(*material.brdf);
#else
    if (!isReconstructed(bytes)) gonio::fuzz::readMaterialBytes(bytes);
#endif
  } catch (const gonio::Error&) {
  }
  return 0;
}
