// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/io/image_io.h"

/// OpenEXR in memory, and the check of sizes for all images; image_io.h reads and writes files.
namespace gonio::io {

bool isExr(std::span<const std::byte> bytes);
/// readImageFile() of an EXR. @throws Error that states what was found.
ImageFile decodeExr(std::span<const std::byte> bytes);
/// @param attributes text attributes. @throws Error for an attribute name that OpenEXR reserves.
std::vector<std::byte> encodeExr(const Image& image, const std::map<std::string, std::string>& attributes);

/// Checks the size that an image's header announces: sides of at most 32768, at most 2^27 pixels, and at most
/// `maxPixelsPerByte` pixels per byte of the file. @throws Error that states the size.
void checkImageSize(long long width, long long height, std::size_t fileBytes, std::size_t maxPixelsPerByte);

}  // namespace gonio::io
