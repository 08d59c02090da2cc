// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gonio::exports {

/// One file of an export, in memory.
struct ExportPart {
  std::string suffix;  ///< appended to the name of the export
  std::vector<std::byte> bytes;
};

/// One file to write.
struct ExportFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes;
};

/// Checks before an export that it can write these files: the folders are writable, no file exists unless `overwrite`
/// is set, and none is one of `sources`, the files that the material uses. Creates no files. @throws Error that names
/// the file.
void checkTargets(std::span<const std::filesystem::path> paths, std::span<const std::filesystem::path> sources,
                  bool overwrite);

/// Writes all files or none (io::writeFilesAtomically()). @throws Error that names the file.
void writeExport(std::span<const ExportFile> files);

}  // namespace gonio::exports
