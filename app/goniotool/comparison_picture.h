// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/math/image.h"
#include "core/rendering/tone_map.h"

namespace gonio::tool {

/// 8-bit RGBA, the first row at the top.
struct DisplayPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Two renderings of the same size side by side, and their error map with a legend (errorMaps()).
DisplayPicture comparisonPicture(const Image& reference, const Image& test, const std::string& referenceName,
                                 const std::string& testName, double exposure, ToneMap toneMap);

}  // namespace gonio::tool
