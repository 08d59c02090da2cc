// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/export/export_files.h"

#include <cstdio>

#include "core/io/atomic_file.h"
#include "core/support/error.h"

namespace gonio::exports {

namespace fs = std::filesystem;

ExportPart textPart(std::string_view suffix, std::string_view text) {
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  return {std::string(suffix), {bytes, bytes + text.size()}};
}

std::string sixDigitText(double number) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", number + 0.0);  // no "-0"
  return digits;
}

std::string colourText(const Rgb& colour, std::string_view separator) {
  return sixDigitText(colour.x) + std::string(separator) + sixDigitText(colour.y) + std::string(separator) +
         sixDigitText(colour.z);
}

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
