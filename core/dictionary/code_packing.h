// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/dictionary/dictionary.h"

/// Serialisation of a code. Unless quantised, coefficients are sorted by index; each index is stored as the difference
/// from the previous one, in a variable number of bytes: seven bits per byte, lowest first, with the eighth bit set if
/// more bytes follow. Quantised codes are compressed (compressChannels()).
namespace gonio::dictionary {

/// Number format of the coefficients.
enum class CodePrecision : std::uint8_t {
  single,    ///< float32
  half,      ///< float16 of the value divided by the largest absolute value of its channel: relative error 2^-11
  quantised  ///< multiples of ChannelCode::step, compressed: about a fifth of the bytes of `half`
};

/// The code with the values of each channel rounded to multiples of ChannelCode::step: 1.4 times the smallest absolute
/// value of a coefficient, which gives the smallest error at equal bytes (docs/results/dictionaries.md), at least 2^-20
/// of the largest. A channel that has a step already stays as it is. No coefficient is lost, unless it is below half of
/// the step.
SparseCode quantised(SparseCode code);

/// The bytes of a quantised code, compressed by range coding: coefficients concentrate at low indices, and the channels
/// of a material resemble each other, so that a coefficient, index and value together, needs about 6 bits. (zstd at its
/// highest level needs 40 to 85 % more bytes for the indices and values.) Per channel: uint8 dictionary, float32 step,
/// float32 ChannelCode::highest, for both orders of the directions float32 ChannelCode::lowest, with
/// SparseCode::hasLargestValues float32 ChannelCode::largestValue, little-endian; then the range coder's bytes, in the
/// order of ChannelCoder (code_packing.cpp). @throws Error for more than 256 dictionaries or 65535 coefficients, or an
/// index outside the grid.
std::vector<std::byte> compressChannels(const SparseCode& code);
/// Inverse of compressChannels(): sets the channels of `code`; set its grid and hasLargestValues before the call.
/// @param hasLowest whether the bytes contain ChannelCode::lowest. @throws Error if there are too few or too many
/// bytes, or a value is not finite or too large.
void expandChannels(std::span<const std::byte> bytes, SparseCode& code, bool hasLowest);
inline void expandChannels(std::span<const std::byte> bytes, SparseCode& code) {
  expandChannels(bytes, code, code.hasBothOrders());
}

/// Per channel: uint8 dictionary, uint16 number of coefficients, float32 scale (largest absolute coefficient), float32
/// ChannelCode::highest, for both orders of the directions float32 ChannelCode::lowest, with
/// SparseCode::hasLargestValues float32 ChannelCode::largestValue, the indices, the values.
/// Little-endian. Quantised: compressChannels(). @throws Error for more than 65535 coefficients or 256 dictionaries, or
/// an index outside the grid.
std::vector<std::byte> packChannels(const SparseCode& code, CodePrecision precision);
/// Inverse of packChannels(): sets the channels of `code`; set its grid and hasLargestValues before the call. @param
/// hasLowest whether the bytes contain ChannelCode::lowest. @throws Error if there are too few or too many bytes, an
/// index is repeated or outside the grid, or a value is not finite.
void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code, bool hasLowest);
inline void unpackChannels(std::span<const std::byte> bytes, CodePrecision precision, SparseCode& code) {
  unpackChannels(bytes, precision, code, code.hasBothOrders());
}

/// The code truncated to the largest number of coefficients per channel with which its quantised form fits in `bytes`;
/// 0 coefficients if no number fits. Precondition: `code` is not quantised (ChannelCode::step is 0).
SparseCode truncatedToBytes(const SparseCode& code, std::size_t bytes);

}  // namespace gonio::dictionary
