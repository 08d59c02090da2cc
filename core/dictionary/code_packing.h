// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/sparse_code.h"

/// Serialisation of a code. Unless quantised, coefficients are sorted by index; each index is stored as the difference
/// from the previous one, in a variable number of bytes: seven bits per byte, lowest first, with the eighth bit set if
/// more bytes follow. Quantised codes are compressed (quantised_code.h).
namespace gonio::dictionary {

/// Number format of the coefficients.
enum class CodePrecision : std::uint8_t {
  single,    ///< float32
  half,      ///< float16 of the value divided by the largest absolute value of its channel: relative error 2^-11
  quantised  ///< multiples of ChannelCode::step, compressed: about a fifth of the bytes of `half`
};

/// Per channel: uint8 dictionary, uint16 number of coefficients, float32 scale (largest absolute coefficient), float32
/// ChannelCode::highest, the indices, the values. Little-endian. Quantised: compressChannels(). @throws Error for more
/// than 65535 coefficients or 256 dictionaries, or an index outside the grid.
std::vector<std::byte> packChannels(const SparseCode& code, CodePrecision precision);
/// Inverse of packChannels(): sets the channels of `code`; set its grid before the call. @throws Error if there are too
/// few or too many bytes, an index is repeated or outside the grid, or a value is not finite.
void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code);

/// The code truncated to the largest number of coefficients per channel with which its quantised form fits in `bytes`;
/// 0 coefficients if no number fits. Precondition: `code` is not quantised (ChannelCode::step is 0).
SparseCode truncatedToBytes(const SparseCode& code, std::size_t bytes);

}  // namespace gonio::dictionary
