// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/brdf/incidence_table_brdf.h"
#include "core/materials/material.h"
#include "core/math/types.h"

namespace gonio::formats {

/// A measurement at scattered pairs of directions, without a grid: the result of readers of such formats.
/// setScattered() converts it to a material.
struct ScatteredSamples {
  std::vector<DirectionPair> directions;  ///< both above the horizon
  std::vector<Rgb> values;                ///< linear RGB, 1/sr, without the cosine, finite and >= 0; one per pair
  std::vector<Rgb> standardDeviations;    ///< of the values, 1/sr; empty if unknown
  std::size_t clampedCount = 0;           ///< number of channel values that were below 0 and were set to 0
  std::size_t belowHorizonCount = 0;      ///< number of rows that were ignored because a direction is at or below the
                                          ///< horizon
  std::string description;                ///< of the sample, from the file; may be empty
  std::vector<std::string> notes;         ///< what the reader recognised (columns, units, decimal sign) and ignored

  /// Adds a row, or only counts it if a direction is at or below the horizon. @param value finite; negative channels
  /// become 0 and are counted.
  void add(const DirectionPair& pair, const Rgb& value) {
    if (!(pair.wi.z > horizonTolerance && pair.wo.z > horizonTolerance)) {
      ++belowHorizonCount;
      return;
    }
    Rgb clamped = value;
    for (int channel = 0; channel < 3; ++channel)
      if (clamped[channel] < 0) {
        clamped[channel] = 0;
        ++clampedCount;
      }
    directions.push_back(pair);
    values.push_back(clamped);
  }
};

/// Reconstructs a whole material from a measurement at scattered pairs of directions: ridge regression over the
/// principal components of the bundled materials (acquisition::reconstruct(); Nielsen et al. 2015, "On Optimal, Minimal
/// BRDF Sampling for Reflectance Acquisition"), sampled on the MERL grid. The material is always isotropic and
/// reciprocal. Each value is limited to the maximum of the bundled materials at its node, or to the maximum of all
/// measured values if that is larger. Points at the same node of bundledBasisGrid are averaged; if more than 8192 nodes
/// remain, an evenly spaced subset is used. Sets all members of the material except name, path, format and hash; its
/// notes state the numbers of used and ignored points and the leave-one-out error. Deterministic. About 1 s, plus
/// bundledBasis() at the first call. @throws Error if no point lies where the bundled materials have values; Cancelled.
void setScattered(const ScatteredSamples& samples, const TaskControl& control, materials::Material& material);

/// The measurement as a table about the normal, if its pairs are all nodes of a grid that is dense enough to be
/// interpolated: each combination of at least three polar angles of the light and three of the viewer, in steps of at
/// most 30 degrees, and of azimuths between them in steps of at most 45 degrees, on one side of the plane of incidence,
/// which then are symmetric, or on both. If the light has several azimuths, at most 45 degrees apart, the table is
/// anisotropic. Angles that differ by less than 1e-5 rad are one; values at one pair are averaged. O(n log n).
std::optional<IncidenceTable> gridOf(const ScatteredSamples& samples);

/// Makes a material of a measurement at pairs of directions: of gridOf(), which returns the values of the file at its
/// directions, or else as setScattered(). @throws as setScattered().
void setPoints(const ScatteredSamples& samples, const TaskControl& control, materials::Material& material);

/// The unit of angles that a file does not state.
struct AngleUnit {
  double radians = 1;  ///< of one unit
  std::string_view name = "radians";

  /// Takes the polar angles and azimuths of the rows: degrees if an angle exceeds a full turn in radians, or a polar
  /// angle half a turn; also if a polar angle exceeds a quarter turn (no reflection is there) and no angle is a simple
  /// fraction of a turn in radians; radians if no angle exceeds these and one is such a fraction. @param angles polar
  /// angle, azimuth, polar angle, azimuth of each row. @param choice how to state the unit, for the error.
  /// @throws Error if a polar angle exceeds a quarter turn, but other angles look like radians; if all angles are small
  /// enough for radians, but none looks like them.
  static AngleUnit guessed(std::span<const std::array<double, 4>> angles, const std::string& choice);
  /// Degrees. Parameters as guessed(). @throws Error if no angle exceeds a full turn in radians and one is a simple
  /// fraction of a turn in radians; if all angles are small enough for radians.
  static AngleUnit degreesUnlessRadians(std::span<const std::array<double, 4>> angles, const std::string& choice);
};

/// MaterialFormat::read of a format of single pairs of directions.
template <ScatteredSamples (*read)(const io::ByteSource& source)>
void readScattered(const io::ByteSource& source, const TaskControl& control, materials::Material& material) {
  control.throwIfStopped();
  setScattered(read(source), control, material);
}

/// The same where the pairs are often a grid: setPoints().
template <ScatteredSamples (*read)(const io::ByteSource& source)>
void readPoints(const io::ByteSource& source, const TaskControl& control, materials::Material& material) {
  control.throwIfStopped();
  setPoints(read(source), control, material);
}

/// The readers of the formats; their files document them.
/// @throws io::FormatMismatch; Error that names the line, for a missing column, a field that is not a finite number, or
/// a number of points other than NUM_POINTS.
ScatteredSamples readAstm(const io::ByteSource& source);
/// @throws io::FormatMismatch if `format:` has a quantity other than BSDF, BRDF or DSF, such as BTDF; Error that names
/// the line, for an incident direction at 90 degrees, angles or values that are not finite numbers and rows of
/// different length; Error if there is no row of reflection.
ScatteredSamples readGoniophotometer(const io::ByteSource& source);
/// @throws io::FormatMismatch that names a line which is not a row of finite numbers, or if there are not 205 rows.
ScatteredSamples readCuret(const io::ByteSource& source);
/// @throws io::FormatMismatch for transmission; Error that names the line, for a tilted sample, azimuths that are not
/// in whole steps and rows of another length; Error if there is no row of reflection.
ScatteredSamples readReflet(const io::ByteSource& source);
/// @throws Error that names the line, for coordinates or values of another kind, a dimension that does not fit, rows of
/// another length and vectors that are not unit vectors; Error for binary data or without a point above the horizon.
ScatteredSamples readAlta(const io::ByteSource& source);
/// @throws Error that names the row of the table, for numbers that are not finite or out of range, a value that is
/// there twice and directions without a value for each wavelength.
ScatteredSamples readOpenMaterial(const io::ByteSource& source);
/// @throws io::FormatMismatch for transmission; Error that names the line, for a word that is not a number, or what was
/// found of the spectrum and the angles; Error for binary data.
ScatteredSamples readSpeos(const io::ByteSource& source);
/// @throws io::FormatMismatch for a table without polar angles, a plan or readings; Error that names line and column.
ScatteredSamples readCsvPoints(const io::ByteSource& source);

}  // namespace gonio::formats
