// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>

#include "core/dictionary/code_packing.h"
#include "core/materials/dictionary_file.h"

/// A file of a sparse code, `.code`: a container (core/io/container.h) "GONIOCOD", uint16 version 1, or 2 for a code of
/// both orders of the directions (dictionary::inBothOrders()); uint8 transform
/// (in the order of dataTransformNames; plus 128 for a code that is not SparseCode::scaled, plus 64 for
/// SparseCode::hasLargestValues), uint8 precision (0 single, 1 half, 2 quantised), uint16 numbers of nodes of theta_h,
/// theta_d, phi_d, uint16 whether phi_d is folded, uint64 id of the ensemble (materials::NamedEnsemble); then
/// dictionary::packChannels(). Quantised, 0.6 to 0.8 kB for 262 coefficients per channel, 2.0 to 2.8 kB for 1,024.
namespace gonio::formats {

/// Size of the file before the packed channels.
inline constexpr std::size_t codeHeaderBytes = 8 + 2 + 1 + 1 + 4 * 2 + 8;

/// The bytes of the file.
std::vector<std::byte> encodeCode(const dictionary::SparseCode& code, std::uint64_t dictionaryId,
                                  dictionary::CodePrecision precision = dictionary::CodePrecision::quantised);
/// Writes a file, atomically. @throws Error that names the file.
void writeCode(const dictionary::SparseCode& code, std::uint64_t dictionaryId, const std::filesystem::path& path,
               dictionary::CodePrecision precision = dictionary::CodePrecision::quantised);

/// A code and the id of its ensemble.
struct CodeFile {
  dictionary::SparseCode code;
  std::uint64_t dictionaryId = 0;
  dictionary::CodePrecision precision = dictionary::CodePrecision::half;
};

/// @throws Error that names the file, what was found and what was expected.
CodeFile readCode(const std::filesystem::path& path);
CodeFile readCode(const io::ByteSource& source);

/// The bundled ensemble of a code. @throws Error if it belongs to another one, or does not fit it (checkCode()).
std::shared_ptr<const materials::NamedEnsemble> bundledDictionaryOf(const CodeFile& code);
/// @throws Error if the code belongs to another ensemble.
void checkDictionary(const CodeFile& code, const materials::NamedEnsemble& dictionary);

}  // namespace gonio::formats
