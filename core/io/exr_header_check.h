// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>

namespace gonio::io {

/// What a picture's header says, checked before it is believed: sides of at most 32768, at most 2^27 pixels, and no
/// more than `maxPixelsPerByte` for each byte of the file.
/// @throws Error that states the size.
void checkImageSize(long long width, long long height, std::size_t fileBytes, std::size_t maxPixelsPerByte);

/// Walks the attributes of all headers of an OpenEXR file and checks that each value has exactly the bytes that it
/// says, and that the picture and its line buffers have reasonable sizes. OpenEXR itself (3.1) reads values of known
/// types whatever size they announce, and allocates what unknown ones announce before it looks for their bytes.
/// @throws Error that states what was found, and where.
void checkExrHeader(std::span<const std::byte> bytes);

}  // namespace gonio::io
