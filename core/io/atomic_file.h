// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace gonio::io {

/// Replaces a file's content in one step: written to a temporary neighbour, flushed, renamed. On failure the old file
/// is as it was and no temporary stays behind.
/// @throws Error naming the file and the system's reason.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> content);
void writeFileAtomically(const std::filesystem::path& path, const std::string& text);

/// One of several files that belong together.
struct FileContent {
  std::filesystem::path path;
  std::span<const std::byte> content;
};

/// All of them or none: every one is written to its temporary neighbour before the first is renamed. Where a rename
/// fails, those files that are new are removed again.
/// @throws Error likewise.
void writeFilesAtomically(std::span<const FileContent> files);

/// For work whose result is written much later: whether writeFileAtomically() would find a folder in which it can make
/// its temporary file. Leaves nothing behind. @throws Error likewise.
void checkWritable(const std::filesystem::path& path);

/// Whether a path leads to one of these files, under whatever name: through links, by a relative path.
bool isOneOf(const std::filesystem::path& path, std::span<const std::filesystem::path> files);

}  // namespace gonio::io
