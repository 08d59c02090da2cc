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
  std::string suffix;  ///< after the export's name
  std::vector<std::byte> bytes;
};

/// One file that is to be written.
struct ExportFile {
  std::filesystem::path path;
  std::vector<std::byte> bytes;
};

/// Whether an export may write these files, for before the work: into folders that take files, no file in use unless
/// `overwrite`, and never over one of `sources`: the files that the material is made of. Leaves nothing behind.
/// @throws Error naming the file.
void checkTargets(std::span<const std::filesystem::path> paths, std::span<const std::filesystem::path> sources,
                  bool overwrite);

/// Writes all of them or none (io::writeFilesAtomically()). @throws Error naming the file.
void writeExport(std::span<const ExportFile> files);

}  // namespace gonio::exports
