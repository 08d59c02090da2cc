// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/math/types.h"

/// Files of exports, and numbers in those that are text.
namespace gonio::exports {

/// One file of an export, in memory.
struct ExportPart {
  std::string suffix;  ///< appended to the name of the export
  std::vector<std::byte> bytes;
};

/// A text file as a part of an export.
ExportPart textPart(std::string_view suffix, std::string_view text);

/// A number with up to six significant digits: "0.25", "1e-05".
std::string sixDigitText(double number);
/// The channels with a separator, e.g. "0.8, 0.4, 0.1".
std::string colourText(const Rgb& colour, std::string_view separator = ", ");

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
