// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/byte_source.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/support/error.h"

namespace gonio::io {

namespace {
/// Number of bytes that are read between two checks of the stop token.
constexpr std::size_t maxPieceBytes = std::size_t(1) << 26;
}  // namespace

std::vector<std::byte> ByteSource::readAll(std::uint64_t maxBytes) const {
  if (size() > maxBytes)
    throw Error("found " + std::to_string(size()) + " bytes, expected at most " + std::to_string(maxBytes));
  std::vector<std::byte> bytes(size());
  readAt(0, bytes);
  return bytes;
}

FileSource::FileSource(const std::filesystem::path& path, std::stop_token stop) : stop_(std::move(stop)) {
  if (path.native().find('\0') != std::string::npos) throw Error("found a NUL character in the path");
  if (const auto error = file_.openForReading(path)) throw Error("cannot be opened: " + error.message());
  if (!file_.isRegular(size_)) throw Error("found a folder, a device, a pipe or a socket, expected a file");
}

void FileSource::readAt(std::uint64_t offset, std::span<std::byte> target) const {
  std::size_t done = 0;
  while (done < target.size()) {
    if (stop_.stop_requested()) throw Cancelled();
    const std::size_t piece = std::min(target.size() - done, maxPieceBytes);
    std::size_t count = 0;
    if (const auto error = file_.readAt(offset + done, target.subspan(done, piece), count))
      throw Error("cannot be read: " + error.message());
    if (count == 0)
      throw Error("ends at byte " + std::to_string(offset + done) + ", expected " + std::to_string(size_) + " bytes");
    done += count;
  }
}

void MemorySource::readAt(std::uint64_t offset, std::span<std::byte> target) const {
  if (offset > bytes_.size() || target.size() > bytes_.size() - offset)
    throw Error("ends at byte " + std::to_string(bytes_.size()) + ", expected " + std::to_string(target.size()) +
                " bytes from byte " + std::to_string(offset));
  if (!target.empty()) std::memcpy(target.data(), bytes_.data() + offset, target.size());
}

std::string base64Text(std::span<const std::byte> bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? unsigned(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

}  // namespace gonio::io
