// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/math/image.h"

namespace gonio::io {

/// Reads an OpenEXR or Radiance HDR picture, found by content, as linear RGB.
/// @throws Error naming the file and what was found.
Image readImage(const std::filesystem::path& path);

/// Writes half-float-free 32-bit OpenEXR (RGB, and A where the image has alpha) with text attributes. Atomic.
void writeExr(const Image& image, const std::filesystem::path& path,
              const std::map<std::string, std::string>& attributes = {});

/// Writes 8-bit sRGB PNG from RGBA display bytes (core/rendering/tone_map.h makes them). Atomic.
void writePng(const std::vector<unsigned char>& rgba, int width, int height, const std::filesystem::path& path);

}  // namespace gonio::io
