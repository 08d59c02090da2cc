// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/csv_text.h"
#include "core/math/types.h"

/// Which columns of a table hold a colour.
namespace gonio::io {

/// A linear sRGB value is the sum of fields times weights.
struct ColourColumns {
  std::vector<std::size_t> columns;
  std::vector<Rgb> weights;

  bool empty() const { return columns.empty(); }
  /// Of a row; channels can be negative (colours outside sRGB, noise).
  /// @throws Error naming line and column where a field is not a finite number, or the sum is not.
  Rgb value(const CsvText& csv, const CsvText::Row& row) const;
};

/// A name as a wavelength, nm: "550", "550nm", "550.5 nm", from 100 to 3000.
std::optional<double> wavelengthOf(const std::string& name);

/// Three or more columns named by wavelengths, in any order, weighted by spectrumWeights(); empty where there are
/// fewer.
/// @throws Error where two name one wavelength.
ColourColumns wavelengthColumns(const CsvText& csv);

/// The columns r, g and b as they are. @throws Error naming the one that is missing.
ColourColumns rgbColumns(const CsvText& csv);

}  // namespace gonio::io
