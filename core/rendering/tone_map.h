// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/math/colour.h"
#include "core/math/image.h"

namespace gonio::rendering {

enum class ToneMap {
  clamp,  ///< linear, clamped to 1
  filmic  ///< Narkowicz 2016, a fitted ACES-like curve
};
std::string_view toneMapName(ToneMap toneMap);

/// Exposure is in stops: radiance x 2^exposure before the curve. Returns display values in [0, 1], still linear.
Rgb toneMapped(const Rgb& radiance, double exposure, ToneMap toneMap);
/// The radiance of which toneMapped() returns a display value; for values of 1 the smallest that is not smaller.
/// @param display in [0, 1].
double radianceOf(double display, double exposure, ToneMap toneMap);
/// 8-bit sRGB RGBA, 4 bytes per pixel. Converts the image's premultiplied colours (core/math/image.h) to straight
/// alpha, as PNG and QImage::Format_RGBA8888 require; alpha is 255 if the image has none. Parallel.
std::vector<std::uint8_t> toDisplayBytes(const Image& image, double exposure, ToneMap toneMap);

}  // namespace gonio::rendering
