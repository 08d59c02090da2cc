// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/math/image.h"

namespace gonio::io {

/// Reads an OpenEXR or Radiance HDR picture, found by content, as linear RGB; alpha where an EXR has it. Values are as
/// the file has them: an EXR may hold negative ones and ones that are not finite. An EXR with a luminance channel only
/// is read as grey. At most 32768 pixels a side and 2^27 in all, checked before anything is allocated for them.
/// @throws Error naming the file and what was found.
Image readImage(const std::filesystem::path& path);
/// The same of bytes in memory; the error names no file.
Image readImage(std::span<const std::byte> bytes);

/// Writes 32-bit float OpenEXR (RGB, and A where the image has alpha; ZIP) with text attributes. Atomic.
/// @throws Error naming the file.
void writeExr(const Image& image, const std::filesystem::path& path,
              const std::map<std::string, std::string>& attributes = {});

/// 8-bit sRGB PNG from RGBA display bytes, the first row at the top (core/rendering/tone_map.h makes them).
/// @throws Error when the bytes are not those of the size.
std::vector<std::byte> encodePng(const std::vector<unsigned char>& rgba, int width, int height);

/// Writes 8-bit sRGB PNG from RGBA display bytes, the first row at the top (core/rendering/tone_map.h makes them).
/// Atomic. @throws Error naming the file.
void writePng(const std::vector<unsigned char>& rgba, int width, int height, const std::filesystem::path& path);

}  // namespace gonio::io
