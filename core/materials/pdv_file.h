// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <string>

#include "core/factorization/pdv_factors.h"
#include "core/io/byte_source.h"

/// Gonio's own file of PDV factors, `.pdv`: a container (core/io/container.h) "GONIOPDV", version 1; uint32 form (0
/// two factors, 1 three), transform (in the order of dataTransformNames), counts of nodes of theta_R, |Dp| and |phi| (1
/// in the form with two factors), count of terms, float32 highest y; the nodes of the three axes; then for red, green
/// and blue, for each term, F1, F2, F3: all float32. 45 KB for ten terms of three factors.
namespace gonio::materials {

/// Bytes of the file.
std::size_t pdvFileBytes(const factorization::PdvFactors& factors);

/// Atomic. Curves are rounded to single precision.
/// @throws Error naming the file.
void writePdv(const factorization::PdvFactors& factors, const std::filesystem::path& path);

/// @throws Error naming the file: what was found, what was expected.
factorization::PdvFactors readPdv(const std::filesystem::path& path);
/// The same of bytes; an error names no file. Nothing is allocated that the source's size does not bear out.
factorization::PdvFactors readPdv(const io::ByteSource& source);

/// Whether a file begins like one. A file that cannot be read does not.
bool isPdv(const std::filesystem::path& path);
/// @throws FormatMismatch when bytes do not begin like one.
void expectPdv(const io::ByteSource& source);

}  // namespace gonio::materials
