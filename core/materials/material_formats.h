// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/byte_source.h"
#include "core/materials/material.h"

/// The one table of the file formats of materials: what readers, writers, dialogs, folders, drag and drop and the
/// command line know of them. A new format is a row of it.
namespace gonio::materials {

enum class FormatId { merl, rgl, utia, zemax, lightTools, astm, goniophotometer, curet, pdv, code };

/// What a file of a format may hold beyond reciprocal, isotropic RGB.
struct FormatCapabilities {
  bool nonReciprocal = false, anisotropic = false, spectral = false;
};

struct MaterialFormat {
  FormatId id;
  std::string_view name;                       ///< MaterialSource::format: "MERL"
  std::string_view label;                      ///< of a file, for people: "MERL table"
  std::span<const std::string_view> suffixes;  ///< with their dot; files are written with the first
  bool hasCommonSuffix;                        ///< other kinds of files have it too: only the content decides
  bool isMeasurement;                          ///< else a model of a measurement: training sets do not take it
  FormatCapabilities holds;
  /// Looks at the start of a file (and its size). @throws FormatMismatch stating what was found and what was expected.
  void (*sniff)(const io::ByteSource& source);
  /// Fills all of a material but its name, path, format and hash, of bytes that were sniffed.
  void (*read)(const io::ByteSource& source, const TaskControl& control, Material& material);
  /// The bytes of a file that holds a table; null where materials are not written in the format.
  std::vector<std::byte> (*write)(const TabulatedBrdf& table);

  std::string_view suffix() const { return suffixes.front(); }
};

/// All formats, in the order in which files are sniffed.
std::span<const MaterialFormat> materialFormats();
const MaterialFormat& formatOf(FormatId id);

/// By the suffix of a name, in either case; null where no format has it as its own. The first of formats that share it.
const MaterialFormat* formatBySuffix(const std::filesystem::path& path);
bool hasSuffixOf(FormatId id, const std::filesystem::path& path);

/// By content, or where no format takes it (a broken file) by suffix; null for all other files.
const MaterialFormat* formatOfFile(const std::filesystem::path& path);

/// By suffix, or where a file of another name begins like one of a format.
bool isMaterialFile(const std::filesystem::path& path);

/// By content. @throws Error listing what each format found where none takes the bytes.
const MaterialFormat& sniffFormat(const io::ByteSource& source);

/// The format that a name asks materials to be written in. @throws Error when its suffix is of no such format.
const MaterialFormat& writableFormat(const std::filesystem::path& path);

/// Suffixes for people, each once: ".binary, .bsdf, .pdv or .code". @param conjunction "or", "and".
std::string suffixText(bool (*isWanted)(const MaterialFormat& format), std::string_view conjunction);
inline bool isAnyFormat(const MaterialFormat&) { return true; }
inline bool isMeasurement(const MaterialFormat& format) { return format.isMeasurement; }
inline bool isWritable(const MaterialFormat& format) { return format.write != nullptr; }

}  // namespace gonio::materials
