// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/brdf/tabulated_brdf.h"
#include "core/io/byte_source.h"

/// The file format of the MERL database (Matusik et al., "A Data-Driven Reflectance Model", 2003), little-endian:
/// three int32 (theta_h, theta_d, phi_d counts: 90, 90, 180), then the red, green and blue planes as float64, phi_d
/// fastest. Raw values times merlScale are linear RGB in 1/sr. Invalid cells hold -1. Non-reciprocal files have
/// 4 theta_d-count samples of phi_d (90, 90, 360) over the whole circle.
namespace gonio::io {

inline constexpr double merlScale[3] = {1.00 / 1500, 1.15 / 1500, 1.66 / 1500};
inline constexpr std::size_t merlHeaderBytes = 12;

/// What a file's bytes say of its grid, checked against their number: nothing is allocated before.
/// @throws FormatMismatch.
HalfDifferenceGrid readMerlHeader(const ByteSource& source);

struct MerlTable {
  std::shared_ptr<const TabulatedBrdf> table;
  std::uint64_t clampedCount = 0;  ///< small negative raw values, in (-1, 0), that became 0
};

/// A cell with any raw channel <= -1 is invalid. Reads in blocks, in parallel; about as fast as memory.
/// @throws FormatMismatch; Error naming the first value that is not finite; Cancelled.
MerlTable readMerl(const ByteSource& source, const TaskControl& control = {});

/// The bytes of a table's file; invalid cells are -1 in all channels.
/// @throws Error when the format cannot represent such a grid (reciprocal exactly where phi_d count = 4 theta_d count).
std::vector<std::byte> encodeMerl(const TabulatedBrdf& table);

}  // namespace gonio::io
