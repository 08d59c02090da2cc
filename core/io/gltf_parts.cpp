// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/gltf_parts.h"

#include <openssl/evp.h>

#include <cstdint>
#include <cstring>
#include <string>

#include "core/support/error.h"

namespace gonio::io {

namespace {

std::uint32_t uint32At(std::span<const std::byte> bytes, std::size_t at) {
  if (at + 4 > bytes.size())
    throw Error("a binary glTF file: found the end of the file, expected the header or a chunk");
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

}  // namespace

GltfParts gltfParts(std::span<const std::byte> bytes) {
  constexpr std::uint32_t magic = 0x46546C67, jsonChunk = 0x4E4F534A, binaryChunk = 0x004E4942;
  if (bytes.size() < 4 || uint32At(bytes, 0) != magic) return {bytes, {}};
  if (const std::uint32_t version = uint32At(bytes, 4); version != 2)
    throw Error("found glTF version " + std::to_string(version) + ", expected 2");
  GltfParts parts;
  for (std::size_t at = 12; at < bytes.size();) {
    const std::uint32_t length = uint32At(bytes, at), kind = uint32At(bytes, at + 4);
    at += 8;
    if (length > bytes.size() - at)
      throw Error("found " + std::to_string(bytes.size() - at) + " bytes of a chunk, expected " +
                  std::to_string(length));
    if (kind == jsonChunk) parts.text = bytes.subspan(at, length);
    if (kind == binaryChunk) parts.binary = bytes.subspan(at, length);
    at += length;
  }
  return parts;
}

std::vector<std::byte> decodedBase64(const JsonObject& buffer, std::string_view text) {
  std::vector<std::byte> bytes(text.size() / 4 * 3 + 3);
  const int length = text.size() > std::size_t(1) << 30 || text.size() % 4 != 0
                         ? -1
                         : EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                           reinterpret_cast<const unsigned char*>(text.data()), int(text.size()));
  if (length < 0) buffer.fail("uri", "base64 data");
  bytes.resize(std::size_t(length));
  return bytes;
}

std::filesystem::path decodedPath(std::string_view address) {
  std::string path;
  for (std::size_t i = 0; i < address.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      const char c = at < address.size() ? address[at] : ' ';
      return c >= '0' && c <= '9'   ? c - '0'
             : c >= 'A' && c <= 'F' ? c - 'A' + 10
             : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                    : -1;
    };
    const bool coded = address[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0;
    path += coded ? char(16 * digit(i + 1) + digit(i + 2)) : address[i];
    if (coded) i += 2;
  }
  return path;
}

}  // namespace gonio::io
