// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

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

}  // namespace gonio::io
