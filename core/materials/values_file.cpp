// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/values_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/math/spectrum.h"
#include "core/support/naming_file.h"
#include "core/support/number_text.h"

namespace gonio::materials {

namespace {

using acquisition::MeasuredValues;
using acquisition::SamplingPlan;

constexpr double shortestWavelength = 100, longestWavelength = 3000;
constexpr std::size_t leastWavelengths = 3;

/// A value is the sum of fields times weights.
struct ValueColumns {
  std::vector<std::size_t> columns;
  std::vector<Rgb> weights;
};
using NoiseColumns = std::array<std::size_t, 3>;

/// "550", "550nm", "550.5 nm".
std::optional<double> wavelengthOf(const std::string& name) {
  double value = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), value);
  if (error != std::errc() || !(value >= shortestWavelength && value <= longestWavelength)) return std::nullopt;
  const std::string rest(end, name.data() + name.size());
  if (rest.empty() || rest == "nm" || rest == " nm") return value;
  return std::nullopt;
}

ValueColumns wavelengthColumns(const io::CsvText& csv) {
  std::map<double, std::size_t> byWavelength;
  for (std::size_t column = 0; column < csv.names.size(); ++column)
    if (const auto wavelength = wavelengthOf(csv.names[column]))
      if (!byWavelength.emplace(*wavelength, column).second)
        throw Error("line " + std::to_string(csv.namesLine) + ": found two columns of " + numberText(*wavelength) +
                    " nm, expected one");
  if (byWavelength.size() < leastWavelengths) return {};
  std::vector<double> wavelengths;
  ValueColumns result;
  for (const auto& [wavelength, column] : byWavelength) {
    wavelengths.push_back(wavelength);
    result.columns.push_back(column);
  }
  result.weights = spectrumWeights(wavelengths);
  return result;
}

/// r, g, b; or where there are none of these, wavelengths.
ValueColumns valueColumns(const io::CsvText& csv) {
  if (!csv.column("r") && !csv.column("g") && !csv.column("b"))
    if (ValueColumns spectrum = wavelengthColumns(csv); !spectrum.columns.empty()) return spectrum;
  return {{csv.neededColumn("r"), csv.neededColumn("g"), csv.neededColumn("b")},
          {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)}};
}

/// Of each channel its own, or one for all.
std::optional<NoiseColumns> noiseColumns(const io::CsvText& csv) {
  if (const auto all = csv.column("noise")) return NoiseColumns{*all, *all, *all};
  if (!csv.column("noise_r") && !csv.column("noise_g") && !csv.column("noise_b")) return std::nullopt;
  return NoiseColumns{csv.neededColumn("noise_r"), csv.neededColumn("noise_g"), csv.neededColumn("noise_b")};
}

double notNegative(const io::CsvText& csv, const io::CsvText::Row& row, std::size_t column) {
  const double value = csv.number(row, column);
  if (value < 0)
    throw Error(io::lineText(row) + ": found " + numberText(value) + " for " + csv.names[column] +
                ", expected a number, 0 or more");
  return value;
}

Rgb valueOf(const io::CsvText& csv, const io::CsvText::Row& row, const ValueColumns& values) {
  Rgb sum(0);
  for (std::size_t i = 0; i < values.columns.size(); ++i)
    sum += notNegative(csv, row, values.columns[i]) * values.weights[i];
  for (int channel = 0; channel < 3; ++channel)
    if (!std::isfinite(sum[channel])) throw Error(io::lineText(row) + ": found values too large for a colour");
  // A colour outside sRGB has a negative channel.
  return glm::max(sum, Rgb(0));
}

/// One column for all tells the noise of each field: their errors are independent.
Rgb noiseOf(const io::CsvText& csv, const io::CsvText::Row& row, const NoiseColumns& noise,
            const ValueColumns& values) {
  if (noise[0] != noise[1])
    return {notNegative(csv, row, noise[0]), notNegative(csv, row, noise[1]), notNegative(csv, row, noise[2])};
  Rgb squares(0);
  for (const Rgb& weight : values.weights) squares += weight * weight;
  return notNegative(csv, row, noise[0]) * glm::sqrt(squares);
}

/// Which row is that of each sample.
std::vector<const io::CsvText::Row*> rowsOf(const io::CsvText& csv, const SamplingPlan& plan) {
  const std::size_t column = csv.neededColumn("index");
  std::map<int, const io::CsvText::Row*> byIndex;
  for (const auto& sample : plan.samples) byIndex[sample.index] = nullptr;
  for (const io::CsvText::Row& row : csv.rows) {
    const int index = csv.integer(row, column);
    const auto found = byIndex.find(index);
    if (found == byIndex.end())
      throw Error(io::lineText(row) + ": found the index " + std::to_string(index) + ", which the plan does not have");
    if (found->second)
      throw Error(io::lineText(row) + ": found the index " + std::to_string(index) + " again, first in " +
                  io::lineText(*found->second));
    found->second = &row;
  }
  std::vector<const io::CsvText::Row*> rows;
  std::string missing;
  for (const auto& sample : plan.samples)
    if (!rows.emplace_back(byIndex[sample.index]))
      missing += (missing.empty() ? "" : ", ") + std::to_string(sample.index);
  if (!missing.empty()) throw Error("found no row of index " + missing + ", expected one for each sample of the plan");
  return rows;
}

std::string fields(const Rgb& value) {
  return "," + numberText(value.x) + "," + numberText(value.y) + "," + numberText(value.z);
}

}  // namespace

std::string valuesCsv(const SamplingPlan& plan, const MeasuredValues& values) {
  const bool hasNoise = !values.noise.empty();
  std::string text = hasNoise ? "index,r,g,b,noise_r,noise_g,noise_b\n" : "index,r,g,b\n";
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    text += std::to_string(plan.samples[i].index) + fields(values.rgb[i]);
    if (hasNoise) text += fields(values.noise[i]);
    text += "\n";
  }
  return text;
}

void writeValues(const SamplingPlan& plan, const MeasuredValues& values, const std::filesystem::path& path) {
  io::writeFileAtomically(path, valuesCsv(plan, values));
}

MeasuredValues parseValues(std::string_view text, const SamplingPlan& plan) {
  const io::CsvText csv = io::readCsvText(text);
  const ValueColumns columns = valueColumns(csv);
  const std::optional<NoiseColumns> noise = noiseColumns(csv);
  MeasuredValues values;
  for (const io::CsvText::Row* row : rowsOf(csv, plan)) {
    values.rgb.push_back(valueOf(csv, *row, columns));
    if (noise) values.noise.push_back(noiseOf(csv, *row, *noise, columns));
  }
  return values;
}

MeasuredValues readValues(const std::filesystem::path& path, const SamplingPlan& plan) {
  return namingFile(path, [&] { return parseValues(io::readText(path), plan); });
}

}  // namespace gonio::materials
