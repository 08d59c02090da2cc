// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace gonio::io {

/// Bytes of known size with random access: a file, or memory. Readers compare announced sizes with size() before they
/// allocate memory. Reading from several threads at once is safe. Errors do not name the file; the caller that knows
/// the path adds it (core/support/file_in_errors.h).
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
  ~FileSource() override;
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;

  std::uint64_t size() const override { return size_; }
  void readAt(std::uint64_t offset, std::span<std::byte> target) const override;

 private:
  int descriptor_ = -1;
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

}  // namespace gonio::io
