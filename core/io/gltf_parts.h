// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/support/json_object.h"

/// Low-level parsing of glTF files: binary container, base64 and URIs.
namespace gonio::io {

/// The JSON text of a file, and its binary part if it has one.
struct GltfParts {
  std::span<const std::byte> text, binary;
};

/// The chunks of a binary file; if the file is not binary, all its bytes as `text`. @throws Error if a chunk is
/// truncated or the version is not supported.
GltfParts gltfParts(std::span<const std::byte> bytes);
/// @throws Error that names the buffer if the text is not base64.
std::vector<std::byte> decodedBase64(const JsonObject& buffer, std::string_view text);
/// A relative URI, with its percent-encoding decoded, as a path.
std::filesystem::path decodedPath(std::string_view address);

}  // namespace gonio::io
