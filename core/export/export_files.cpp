// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_files.h"

#include "core/io/atomic_file.h"
#include "core/support/error.h"

namespace gonio::exports {

namespace fs = std::filesystem;

void checkTargets(std::span<const fs::path> paths, std::span<const fs::path> sources, bool overwrite) {
  for (const fs::path& path : paths) {
    std::error_code ignored;
    if (io::isOneOf(path, sources))
      throw Error(path.string() + ": is a measured file that this material uses, expected another name");
    if (!overwrite && fs::exists(path, ignored))
      throw Error(path.string() + ": exists already, expected a new name (or --force)");
    io::checkWritable(path);
  }
}

void writeExport(std::span<const ExportFile> files) {
  std::vector<io::FileContent> contents;
  for (const ExportFile& file : files) contents.push_back({file.path, file.bytes});
  io::writeFilesAtomically(contents);
}

}  // namespace gonio::exports
