// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/dictionary/code_packing.h"
#include "core/materials/dictionary_file.h"
#include "core/materials/material.h"

/// A file of a sparse code, `.code`: a container (core/io/container.h) "GONIOCOD", uint16 version 1; uint8 transform
/// (in the order of dataTransformNames), uint8 precision (0 single, 1 half), uint16 counts of theta_h, theta_d, phi_d,
/// uint16 whether phi_d is folded, uint64 id of the dictionary; then the packed channels (dictionary::packChannels).
/// About 3 KB for 262 coefficients a channel in half precision.
namespace gonio::materials {

/// What the file has before the packed channels.
inline constexpr std::size_t codeHeaderBytes = 8 + 2 + 1 + 1 + 4 * 2 + 8;

/// The bytes of the file.
std::vector<std::byte> encodeCode(const dictionary::SparseCode& code, std::uint64_t dictionaryId,
                                  dictionary::CodePrecision precision = dictionary::CodePrecision::half);
/// Atomic. @throws Error naming the file.
void writeCode(const dictionary::SparseCode& code, std::uint64_t dictionaryId, const std::filesystem::path& path,
               dictionary::CodePrecision precision = dictionary::CodePrecision::half);

/// A code with the id of the dictionary that it is over.
struct CodeFile {
  dictionary::SparseCode code;
  std::uint64_t dictionaryId = 0;
  dictionary::CodePrecision precision = dictionary::CodePrecision::half;
};

/// @throws Error naming the file: what was found, what was expected.
CodeFile readCode(const std::filesystem::path& path);
CodeFile readCode(const io::ByteSource& source);
/// @throws FormatMismatch when the bytes do not begin like a code.
void expectCode(const io::ByteSource& source);

/// @throws Error when the code is over another dictionary.
void checkDictionary(const CodeFile& code, const NamedEnsemble& dictionary);

/// Makes a material what a code over bundledDictionary() stands for: decoded, with a description. Under 50 ms.
/// @throws Error when it is over another dictionary.
void setCode(const CodeFile& code, Material& material);

}  // namespace gonio::materials
