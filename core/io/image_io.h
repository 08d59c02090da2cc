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

/// An image as it was read from a file.
struct ImageFile {
  Image image;
  std::vector<std::string> notes;  ///< what the reader converted, such as other primaries, for people
  std::string layout;              ///< the attribute layoutAttribute of an EXR; may be empty
};

/// Attribute of EXR files that Gonio writes in another layout than latitude and longitude; its text names the layout.
inline constexpr const char* layoutAttribute = "gonio layout";

/// Reads an OpenEXR or Radiance HDR image, recognised by content, as linear sRGB, with alpha if an EXR has it. An EXR
/// may contain negative values and values that are not finite. The headers that change the meaning of pixels are
/// honoured: of an EXR the chromaticities, luminance-chroma channels (half precision), the display window (pixels
/// outside the data window are 0) and `envmap` (a cube becomes a latitude-longitude map); of an HDR those of
/// decodeHdr(). An EXR with only a luminance channel is read as grey. At most 32768 pixels per side and 2^27 in total,
/// checked before memory is allocated. @throws Error that names the file and states what was found.
ImageFile readImageFile(const std::filesystem::path& path);
/// The same for bytes in memory; the error names no file.
ImageFile readImageFile(std::span<const std::byte> bytes);
/// ImageFile::image alone.
Image readImage(const std::filesystem::path& path);
Image readImage(std::span<const std::byte> bytes);

/// Reads a PNG or JPEG image: the values as they are stored, of 8 or 16 bit, scaled to 0 to 1. They are not linear, and
/// profiles and alpha are not read. The size is limited as above. @throws Error that names the file.
Image readEncodedImage(const std::filesystem::path& path);
/// The same for bytes in memory; the error names no file.
Image readEncodedImage(std::span<const std::byte> bytes);

/// Writes 32-bit float OpenEXR (RGB, and A where the image has alpha; ZIP) with text attributes, atomically.
/// @throws Error that names the file.
void writeExr(const Image& image, const std::filesystem::path& path,
              const std::map<std::string, std::string>& attributes = {});

/// 8-bit sRGB PNG from RGBA display bytes (core/rendering/tone_map.h), top row first. @throws Error if the number of
/// bytes does not match the size.
std::vector<std::byte> encodePng(const std::vector<unsigned char>& rgba, int width, int height);

/// Writes encodePng() to a file, atomically. @throws Error that names the file.
void writePng(const std::vector<unsigned char>& rgba, int width, int height, const std::filesystem::path& path);

}  // namespace gonio::io
