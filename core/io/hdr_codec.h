// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>

#include "core/io/image_io.h"

/// Radiance HDR in memory; image_io.h reads files.
namespace gonio::io {

bool isHdr(std::span<const std::byte> bytes);

/// A Radiance picture (Ward 1991, "Real Pixels", Graphics Gems II.5; Radiance 5.4, src/common/color.c, resolu.c): flat
/// pixels, and run-length coding of both kinds, old (1, 1, 1, n) and new (2, 2, length). Every orientation of the
/// resolution line. RGBE, and XYZE as X, Y, Z. Divides by EXPOSURE and COLORCORR (their products, if they occur
/// repeatedly), so that the values are radiance; converts PRIMARIES to sRGB (toSrgbMatrix()); zeros there, as Photoshop
/// writes them, count as none. @throws Error that states what was found.
ImageFile decodeHdr(std::span<const std::byte> bytes);

}  // namespace gonio::io
