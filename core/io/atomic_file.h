// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <system_error>

#include "core/support/system.h"

namespace gonio::io {

/// Replaces a file's content in one step: writes a temporary file in the same folder, flushes and renames it. On
/// failure the old file is unchanged and the temporary file is removed. @throws Error that names the file and the
/// system's reason; also for folders, devices, pipes and sockets.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);
void writeFileAtomically(const std::filesystem::path& path, const std::string& text);

/// One of several files to write together.
struct FileContent {
  std::filesystem::path path;
  std::span<const std::byte> content;
};

/// Writes several files, all or none: all temporary files are written before the first is renamed, and the old files
/// keep a second name (a hard link) until all new ones are in place. If a rename fails, the old files come back and new
/// ones are removed. @throws as writeFileAtomically(). On a file system without hard links the error also names the
/// files that were already replaced.
void writeFilesAtomically(std::span<const FileContent> files);

/// Checks before a long computation that writeFileAtomically() could create its temporary file. Leaves no file.
/// @throws as writeFileAtomically().
void checkWritable(const std::filesystem::path& path);

/// Whether a path refers to one of these files, also through links or as a relative path.
bool isOneOf(const std::filesystem::path& path, std::span<const std::filesystem::path> files);

/// A temporary file for data that does not fit into memory. It has no directory entry and is deleted with the object,
/// even if the program is killed.
class ScratchFile {
 public:
  /// @throws Error that names the folder if no file can be created there, or if its file system has less than `bytes`
  /// free.
  ScratchFile(const std::filesystem::path& folder, std::uint64_t bytes);

  /// @throws Error that names the folder if the disk is full or fails.
  void write(std::uint64_t offset, std::span<const float> values);
  /// Values that were written. May be called from several threads. @throws Error that names the folder.
  void read(std::uint64_t offset, std::span<float> values) const;

 private:
  [[noreturn]] void fail(const char* what, const std::error_code& reason) const;

  std::filesystem::path folder_;
  system::File file_;
};

}  // namespace gonio::io
