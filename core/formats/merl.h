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
/// fastest. Raw values times merlScale are linear RGB, 1/sr, without the cosine. Invalid cells contain -1.
/// Non-reciprocal files have phi_d over the whole circle, with four times as many samples as theta_d (90, 90, 360).
namespace gonio::formats {

inline constexpr double merlScale[3] = {1.00 / 1500, 1.15 / 1500, 1.66 / 1500};
inline constexpr std::size_t merlHeaderBytes = 12;

/// The grid that the header announces, checked against the size of the file. @throws io::FormatMismatch.
HalfDifferenceGrid readMerlHeader(const io::ByteSource& source);

struct MerlTable {
  std::shared_ptr<const TabulatedBrdf> table;
  std::uint64_t clampedCount = 0;  ///< number of raw values in (-1, 0), which became 0
};

/// A cell with a raw value <= -1 in any channel is invalid. Parallel. @throws io::FormatMismatch; Error that names the
/// first value that is not finite; Cancelled.
MerlTable readMerl(const io::ByteSource& source, const TaskControl& control = {});

/// The file of a table; invalid cells are -1 in all channels. @throws Error if the format cannot represent the grid: by
/// the header, a grid is non-reciprocal if and only if its phi_d count is 4 times the theta_d count.
std::vector<std::byte> encodeMerl(const TabulatedBrdf& table);

}  // namespace gonio::formats
