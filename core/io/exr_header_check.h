// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>

namespace gonio::io {

/// Checks the size that an image's header announces: sides of at most 32768, at most 2^27 pixels, and at most
/// `maxPixelsPerByte` pixels per byte of the file. @throws Error that states the size.
void checkImageSize(long long width, long long height, std::size_t fileBytes, std::size_t maxPixelsPerByte);

/// Checks all headers of an OpenEXR file: every attribute value must have exactly the announced size, and image and
/// line buffers must have reasonable sizes. Needed because OpenEXR 3.1 reads values of known types regardless of the
/// announced size, and allocates the announced size of unknown types before it reads them. @throws Error that states
/// what was found, and where.
void checkExrHeader(std::span<const std::byte> bytes);

}  // namespace gonio::io
