// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

namespace gonio::io {

/// A temporary file for data that does not fit into memory. It has no directory entry and is deleted with the object,
/// even if the program is killed.
class ScratchFile {
 public:
  /// @throws Error that names the folder if no file can be created there, or if its file system has less than `bytes`
  /// free.
  ScratchFile(const std::filesystem::path& folder, std::uint64_t bytes);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  /// @throws Error that names the folder if the disk is full or fails.
  void write(std::uint64_t offset, std::span<const float> values);
  /// Values that were written. May be called from several threads. @throws Error that names the folder.
  void read(std::uint64_t offset, std::span<float> values) const;

 private:
  [[noreturn]] void fail(const char* what) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
};

}  // namespace gonio::io
