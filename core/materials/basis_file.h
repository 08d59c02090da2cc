// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/dictionary/principal_components.h"
#include "core/io/byte_source.h"

/// A file of principal components, `.basis`: what materials are reconstructed in from the samples of a plan.
/// A container (core/io/container.h) "GONIOPCA", version 2; a description with the grid, the counts of cells,
/// components and signals, the precision and what it learned from; then
///   the cells that count, one bit a cell of the grid, the lowest bit first; for each of them the reference and the
///   mean (float32); the root of leftOutVariance() of the components that are kept: the largest (float32), then each
///   over it, float16 or float32; the singular values, then V column by column (float64); for each component the
///   largest entry of U (float32), then U over it, float16 or float32.
/// The weights of the cells follow from the grid. 1.1 million cells: 11.1 MB and 2.2 MB a component in half precision,
/// by which a mapped value of size y moves by less than about y / 2000.
namespace gonio::materials {

inline constexpr std::string_view basisSuffix = ".basis";

enum class BasisPrecision { single, half };

struct BasisFile {
  dictionary::PrincipalComponents components;
  std::vector<std::string> learnedFrom;  ///< names of the materials
};

/// @param components the first ones that are kept, at most those that there are.
std::vector<std::byte> encodeBasis(const dictionary::PrincipalComponents& basis, int components,
                                   const std::vector<std::string>& learnedFrom,
                                   BasisPrecision precision = BasisPrecision::half);
/// Atomic. @throws Error naming the file.
void writeBasis(const dictionary::PrincipalComponents& basis, int components,
                const std::vector<std::string>& learnedFrom, const std::filesystem::path& path,
                BasisPrecision precision = BasisPrecision::half);

/// @throws Error naming the file: what was found, what was expected. Nothing is allocated that the file's size does not
/// bear out.
std::shared_ptr<const BasisFile> readBasis(const std::filesystem::path& path);
/// The same of bytes; an error names no file.
std::shared_ptr<const BasisFile> readBasis(const io::ByteSource& source);

}  // namespace gonio::materials
