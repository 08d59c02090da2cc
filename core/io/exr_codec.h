// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/math/image.h"

/// OpenEXR in memory; image_io.h reads and writes files.
namespace gonio::io {

bool isExr(std::span<const std::byte> bytes);
/// @throws Error that states what was found.
Image decodeExr(std::span<const std::byte> bytes);
/// @param attributes text attributes. @throws Error for an attribute name that OpenEXR reserves.
std::vector<std::byte> encodeExr(const Image& image, const std::map<std::string, std::string>& attributes);

}  // namespace gonio::io
