// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/csv_text.h"
#include "core/math/types.h"

/// The columns of a table that contain a colour.
namespace gonio::io {

/// A linear sRGB value as the sum of columns times weights.
struct ColourColumns {
  std::vector<std::size_t> columns;
  std::vector<Rgb> weights;

  bool empty() const { return columns.empty(); }
  /// The value of a row; channels can be negative (colours outside the sRGB gamut, noise). @throws Error that names
  /// line and column if a field or the sum is not a finite number.
  Rgb value(const CsvText& csv, const CsvText::Row& row) const;
};

/// The wavelength in nm that a column name states, from 100 to 3000: "550", "550nm", "550.5 nm". Empty for other names.
std::optional<double> wavelengthOf(const std::string& name);

/// The columns named by wavelengths, in any order, with spectrumWeights(); empty if there are fewer than three.
/// @throws Error if two columns have the same wavelength.
ColourColumns wavelengthColumns(const CsvText& csv);

/// The columns r, g and b. @throws Error that names a missing one.
ColourColumns rgbColumns(const CsvText& csv);

}  // namespace gonio::io
