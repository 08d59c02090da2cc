// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/support/error.h"
#include "core/support/system.h"

namespace gonio::io {

static_assert(std::endian::native == std::endian::little, "values are written as they lie in memory");

template <typename T>
requires std::is_trivially_copyable_v<T> &&
    (!std::is_convertible_v<const T&, std::string_view>)void append(std::vector<std::byte>& bytes, const T& value) {
  const auto raw = std::as_bytes(std::span(&value, 1));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

inline void append(std::vector<std::byte>& bytes, std::string_view text) {
  const auto raw = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

/// Bytes of known size with random access: a file, or memory. Readers compare announced sizes with size() before they
/// allocate memory. Reading from several threads at once is safe. Errors do not name the file; the caller that knows
/// the path adds it (core/support/error.h).
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// Fills `target` from `offset`.
  /// @throws Error if the source ends too early (such as a file that was truncated meanwhile) or the system reports an
  /// error; Cancelled.
  virtual void readAt(std::uint64_t offset, std::span<std::byte> target) const = 0;

  /// All bytes.
  /// @throws Error as readAt(), and if there are more than `maxBytes`.
  std::vector<std::byte> readAll(std::uint64_t maxBytes = std::uint64_t(1) << 33) const;
};

class FileSource final : public ByteSource {
 public:
  /// @param stop makes readAt() throw Cancelled, within 64 MiB.
  /// @throws Error that states the system's reason; also for folders, devices, pipes and sockets, without waiting.
  explicit FileSource(const std::filesystem::path& path, std::stop_token stop = {});

  std::uint64_t size() const override { return size_; }
  void readAt(std::uint64_t offset, std::span<std::byte> target) const override;

 private:
  system::File file_;
  std::uint64_t size_ = 0;
  std::stop_token stop_;
};

/// Bytes in memory, which must outlive this object.
class MemorySource final : public ByteSource {
 public:
  explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  void readAt(std::uint64_t offset, std::span<std::byte> target) const override;

 private:
  std::span<const std::byte> bytes_;
};

/// Bytes as base64 text (RFC 4648, with padding), for data URIs.
std::string base64Text(std::span<const std::byte> bytes);

/// The bytes are in another format, or a damaged file of this format. If no reader accepts a file, the final error
/// lists what each of them found.
class FormatMismatch : public Error {
 public:
  using Error::Error;
  FormatMismatch(const std::string& found, const std::string& expected)
      : Error("found " + found + "; expected " + expected) {}

  /// For a file that has the format but ends too early.
  static FormatMismatch truncated(const std::string& found, const std::string& expected, std::uint64_t bytes,
                                  std::uint64_t wholeBytes) {
    FormatMismatch mismatch(found, expected);
    mismatch.verdict_ = "the file is truncated: " + std::to_string(bytes) + " bytes of " + std::to_string(wholeBytes);
    return mismatch;
  }
  /// A short explanation if the file has this format nevertheless; otherwise empty.
  const std::string& verdict() const { return verdict_; }

 private:
  std::string verdict_;
};

}  // namespace gonio::io
