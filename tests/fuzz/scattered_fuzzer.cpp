// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "tests/fuzz/reader_targets.h"

/// libFuzzer: all readers of scattered points, without the reconstruction that makes a material of them.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  for (const auto read : {gonio::fuzz::readScatteredBytes<gonio::formats::readAstm>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readGoniophotometer>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readCuret>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readCsvPoints>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readReflet>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readAlta>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readOpenMaterial>,
                          gonio::fuzz::readScatteredBytes<gonio::formats::readSpeos>}) {
    try {
      read(bytes);
    } catch (const gonio::Error&) {
    }
  }
  return 0;
}
