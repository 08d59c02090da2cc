// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <string_view>

#include "core/formats/scattered_samples.h"
#include "core/io/csv_text.h"

/// Points of a measurement as a table with named columns: what ASTM files and CSV files have in common.
///
/// Angles: polar angle from the normal and azimuth, of the direction to the light (theta_i, phi_i; phi_i is 0 if
/// missing) and of the scattered light (theta_s, phi_s; also _r, _o, _v; _in and _out). In place of phi_s, dphi (or
/// delta_phi) is the azimuth from that of the light. A name may state the unit: "theta_i [deg]", "theta_i (rad)".
/// Values: BRDF in 1/sr, without the cosine: R, G, B or red, green, blue (linear sRGB); X, Y, Z (D65 white at Y = 1);
/// three or more wavelengths ("550nm", "0.55um", spectrumWeights()); a column named BRDF, BSDF or value; or a single
/// other column. The last two are read as grey. Several columns that may be the values are refused.
namespace gonio::formats {

/// Text of tables up to 64 MiB; their fields take about ten times as much memory.
constexpr std::uint64_t maxPointTableBytes = 1 << 26;

/// The unit of angles where no column states it.
enum class DefaultUnit {
  guessed,  ///< AngleUnit::guessed()
  degrees   ///< AngleUnit::degreesUnlessRadians()
};

/// Whether a table has columns of both polar angles.
bool hasPolarAngles(const io::CsvText& csv);

/// The rows of a table. Its first note states how columns, unit and decimal sign were read, another one the columns
/// that are not used. @throws Error that names line and column: a column that is missing or there twice, columns of
/// values that can be read in two ways, a field that is not a finite number, angles in two units or an unknown one.
ScatteredSamples readPointTable(const io::CsvText& csv, DefaultUnit unit);

}  // namespace gonio::formats
