// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/math/image.h"
#include "core/math/srgb.h"

namespace gonio {

enum class ToneMap {
  clamp,  ///< linear, cut at 1
  filmic  ///< Narkowicz 2016, a fitted ACES-like curve
};
std::string_view toneMapName(ToneMap toneMap);

/// Exposure is in stops: radiance x 2^exposure before the curve. Returns display values in [0, 1], still linear.
Rgb toneMapped(const Rgb& radiance, double exposure, ToneMap toneMap);
/// 8-bit sRGB RGBA, 4 bytes per pixel. The image's colours are premultiplied by its alpha (core/math/image.h), the
/// bytes are straight, as PNG and QImage::Format_RGBA8888 take them; alpha 255 where the image has none. In parallel.
std::vector<std::uint8_t> toDisplayBytes(const Image& image, double exposure, ToneMap toneMap);

}  // namespace gonio
