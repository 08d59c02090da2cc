// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/support/json_object.h"

/// The bytes of glTF files: containers and addresses.
namespace gonio::io {

/// The JSON text of a file, and its binary part if it has one.
struct GltfParts {
  std::span<const std::byte> text, binary;
};

/// Of a binary file its chunks, of another all as text. @throws Error where a chunk is cut off; of another version.
GltfParts gltfParts(std::span<const std::byte> bytes);
/// @throws Error naming the buffer where the text is not base64.
std::vector<std::byte> decodedBase64(const JsonObject& buffer, std::string_view text);
/// A relative address with its %20 and the like as a path.
std::filesystem::path decodedPath(std::string_view address);

}  // namespace gonio::io
