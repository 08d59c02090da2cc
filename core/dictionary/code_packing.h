// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/sparse_code.h"

/// The bytes of a code. Coefficients stand in the order of their indices; of each index the distance from the one
/// before is written, seven bits a byte, the lowest first, the eighth bit says that more follow.
namespace gonio::dictionary {

/// How the values of the coefficients are written.
enum class CodePrecision : std::uint8_t {
  single,  ///< float32
  half     ///< float16 of the value over the channel's largest: relative error 2^-11, far below what is left out
};

/// For each channel: uint8 dictionary, uint16 count of coefficients, float32 scale, float32 highest value, the indices,
/// the values. Little-endian. @throws Error for more than 65535 coefficients or 256 dictionaries.
std::vector<std::byte> packChannels(const SparseCode& code, CodePrecision precision);
/// Their inverse, into the channels of `code`, whose grid is set.
/// @throws Error when the bytes end before, hold more, or hold an index beyond the grid or a value that is not finite.
void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code);

/// The largest truncation of a code that packs (in half precision) into so many bytes; one without coefficients where
/// there is none.
SparseCode truncatedToBytes(const SparseCode& code, std::size_t bytes);

}  // namespace gonio::dictionary
