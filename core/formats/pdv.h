// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/factorization/pdv_factors.h"
#include "core/io/byte_source.h"

/// Gonio's file format of PDV factors, `.pdv`: a container (core/io/container.h) "GONIOPDV", version 1, or 2 with
/// negative values; uint32 form (0 two factors, 1 three), transform (in the order of dataTransformNames), numbers of
/// nodes of theta_R, |Dp| and |phi| (1 in the two-factor form), number of terms; float32 PdvFactors::highest and, in
/// version 2, lowest; the nodes of the three axes; then for red, green and blue, for each term, F1, F2, F3, all
/// float32. 45 kB for ten terms of three factors.
namespace gonio::formats {

/// Size of the file in bytes.
std::size_t pdvFileBytes(const factorization::PdvFactors& factors);
/// Size of a file with this number of terms over the nodes of factorizePdv(): 44,680 bytes for ten terms of three
/// factors.
std::size_t pdvFileBytes(factorization::PdvForm form, int terms);

/// Writes a file, atomically. Curves are rounded to single precision. @throws Error that names the file.
void writePdv(const factorization::PdvFactors& factors, const std::filesystem::path& path);

/// @throws Error that names the file, what was found and what was expected.
factorization::PdvFactors readPdv(const std::filesystem::path& path);
/// The same for bytes; errors name no file. Checks the size of the source before memory is allocated.
factorization::PdvFactors readPdv(const io::ByteSource& source);

/// Whether a file begins like a PDV file; false if it cannot be read.
bool isPdv(const std::filesystem::path& path);

}  // namespace gonio::formats
