// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/colour_columns.h"

#include <charconv>
#include <cmath>
#include <map>

#include "core/math/spectrum.h"
#include "core/support/error.h"
#include "core/support/number_text.h"

namespace gonio::io {

namespace {

constexpr double shortestWavelength = 100, longestWavelength = 3000;
constexpr std::size_t minWavelengths = 3;

}  // namespace

Rgb ColourColumns::value(const CsvText& csv, const CsvText::Row& row) const {
  Rgb sum(0);
  for (std::size_t i = 0; i < columns.size(); ++i) sum += csv.number(row, columns[i]) * weights[i];
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isfinite(sum[channel])) throw Error(lineText(row) + ": found values too large for a colour");
  return sum;
}

std::optional<double> wavelengthOf(const std::string& name) {
  double value = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  if (error != std::errc() || !(value >= shortestWavelength && value <= longestWavelength)) return std::nullopt;
  const std::string rest(end, name.data() + name.size());
  if (rest.empty() || rest == "nm" || rest == " nm") return value;
  return std::nullopt;
}

ColourColumns wavelengthColumns(const CsvText& csv) {
  std::map<double, std::size_t> byWavelength;
  for (std::size_t column = 0; column < csv.names.size(); ++column)
    if (const auto wavelength = wavelengthOf(csv.names[column]))
      if (!byWavelength.emplace(*wavelength, column).second)
        throw Error("line " + std::to_string(csv.headerLine) + ": found two columns of " + numberText(*wavelength) +
                    " nm, expected one");
  if (byWavelength.size() < minWavelengths) return {};
  std::vector<double> wavelengths;
  ColourColumns result;
  for (const auto& [wavelength, column] : byWavelength) {
    wavelengths.push_back(wavelength);
    result.columns.push_back(column);
  }
  result.weights = spectrumWeights(wavelengths);
  return result;
}

ColourColumns rgbColumns(const CsvText& csv) {
  return {{csv.requiredColumn("r"), csv.requiredColumn("g"), csv.requiredColumn("b")},
          {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)}};
}

}  // namespace gonio::io
