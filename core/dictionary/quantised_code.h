// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/dictionary/sparse_code.h"

/// Codes with values that are multiples of a step, compressed by range coding. Coefficients concentrate at low indices,
/// and the channels of a material resemble each other, so that a coefficient, index and value together, needs about
/// 6 bits.
namespace gonio::dictionary {

/// The code with the values of each channel rounded to multiples of ChannelCode::step: 1.4 times the smallest absolute
/// value of a coefficient, which gives the smallest error at equal bytes (docs/results/dictionaries.md), at least 2^-20
/// of the largest. A channel that has a step already stays as it is. No coefficient is lost, unless it is below half of
/// the step.
SparseCode quantised(SparseCode code);

/// The bytes of a quantised code. Per channel: uint8 dictionary, float32 step, float32 ChannelCode::highest,
/// little-endian; then the range coder's bytes (docs/formats.md). @throws Error for more than 256 dictionaries or 65535
/// coefficients, or an index outside the grid.
std::vector<std::byte> compressChannels(const SparseCode& code);
/// Inverse of compressChannels(): sets the channels of `code`; set its grid before the call. @throws Error if there are
/// too few or too many bytes, or a value is not finite or too large.
void expandChannels(std::span<const std::byte> bytes, SparseCode& code);

}  // namespace gonio::dictionary
