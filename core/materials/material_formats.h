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

/// The table of file formats of materials, which readers, writers, dialogs, folders, drag and drop and the command line
/// use. How to add one: CONTRIBUTING.md, "Add a material format".
namespace gonio::materials {

/// What a format can represent beyond reciprocal, isotropic RGB.
struct FormatCapabilities {
  bool nonReciprocal = false, anisotropic = false, spectral = false;
};

struct EditedMaterial;
struct EncodeOptions;
struct Encoded;

struct MaterialFormat {
  std::string_view name;                       ///< MaterialSource::format, e.g. "MERL"
  std::string_view label;                      ///< for display, e.g. "MERL file"
  std::span<const std::string_view> suffixes;  ///< with the dot; files are written with the first
  bool isSuffixAmbiguous = false;  ///< whether files that are not materials often have the suffix (.bin, .exr, .txt,
                                   ///< .dat), so that it does not identify a material
  bool isMeasurement = false;      ///< false: modelled or reconstructed from a measurement; training sets exclude it
  FormatCapabilities holds = {};
  /// Recognises a file by its start and size. @throws FormatMismatch that states what was found and what was expected.
  void (*sniff)(const io::ByteSource& source);
  /// Reads a file that `sniff` accepted: sets all members of the material except name, path, format and hash.
  void (*read)(const io::ByteSource& source, const TaskControl& control, Material& material);
  /// The file of a material and what it loses, for encode() alone (core/materials/encode.h); null if the format is only
  /// read.
  Encoded (*encode)(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control) = nullptr;
  /// Whether `read` returns BRDFs of this kind, so that the format is the first choice for writing one; null where
  /// `encode` is.
  bool (*isOwnForm)(const Brdf& brdf) = nullptr;

  std::string_view suffix() const { return suffixes.front(); }
};

/// All formats, in the order of lists for people: formats::allFormats, which core/formats defines.
std::span<const MaterialFormat* const> materialFormats();

/// The first format with the suffix of a name, in upper or lower case (RGL for `.bsdf`); null if there is none or the
/// suffix is ambiguous (isSuffixAmbiguous).
const MaterialFormat* formatBySuffix(const std::filesystem::path& path);
/// Whether formatBySuffix() returns this format: never for a format with an ambiguous suffix, nor for Zemax and
/// LightTools, which share `.bsdf` with RGL.
inline bool hasSuffixOf(const MaterialFormat& format, const std::filesystem::path& path) {
  return formatBySuffix(path) == &format;
}

/// The format by content, or by suffix if no format accepts the content (a damaged file); null for other files.
const MaterialFormat* formatOfFile(const std::filesystem::path& path);

/// Whether a file has a format's suffix or content.
bool isMaterialFile(const std::filesystem::path& path);

/// The format by content. @throws Error that lists what each format found, if none accepts the bytes.
const MaterialFormat& sniffFormat(const io::ByteSource& source);

/// What a file is by its suffix, if Gonio knows its format but does not read it: "a polarimetric BSDF (.pbsdf)"; empty
/// for other suffixes. sniffFormat() names such files that it recognises by content.
std::string unreadFormat(const std::filesystem::path& path);

/// The suffixes of formats as text, each once: ".binary, .bsdf, .pdv or .code". @param conjunction "or" or "and".
std::string suffixText(bool (*isWanted)(const MaterialFormat& format), std::string_view conjunction);
inline bool isAnyFormat(const MaterialFormat&) { return true; }
inline bool isMeasurement(const MaterialFormat& format) { return format.isMeasurement; }
/// The suffixes with which files are written, and another one unless it is empty: ".binary, .bsdf or .bin".
std::string writableSuffixText(std::string_view other = {});

}  // namespace gonio::materials
