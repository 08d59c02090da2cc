// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/measured_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <random>

#include "core/acquisition/sample_rows.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"
#include "core/support/text.h"

namespace gonio::acquisition {

namespace {

/// The direction turned by |offset| (rad) along the tangent that `offset` names.
Direction turned(const Direction& w, const glm::dvec2& offset) {
  const double angle = glm::length(offset);
  if (angle == 0) return w;
  const Direction aside = std::abs(w.x) < 0.5 ? Direction(1, 0, 0) : Direction(0, 1, 0);
  const Direction u = glm::normalize(glm::cross(w, aside)), v = glm::cross(w, u);
  Direction result = std::cos(angle) * w + std::sin(angle) / angle * (offset.x * u + offset.y * v);
  result.z = std::max(0.0, result.z);
  return glm::normalize(result);
}

void checkError(double error, const char* what) {
  if (!(error >= 0) || !std::isfinite(error))
    throw Error(std::string(what) + ": found " + numberText(error) + ", expected a finite number, 0 or more");
}

}  // namespace

MeasuredValues measure(const Brdf& material, const SamplingPlan& plan, const MeasurementNoise& noise) {
  checkError(noise.relative, "the relative noise");
  checkError(noise.absolute, "the absolute noise");
  checkError(noise.misalignment, "the misalignment");
  std::mt19937_64 random(noise.seed);
  std::normal_distribution<double> gaussian;
  const auto pair = [&] {
    const double x = gaussian(random), y = gaussian(random);
    return glm::dvec2(x, y);
  };
  const bool isNoisy = noise.relative > 0 || noise.absolute > 0;
  MeasuredValues measured;
  for (const PlannedSample& sample : plan.samples) {
    const glm::dvec2 ofLight = pair(), ofViewer = pair();
    const Rgb value = glm::max(Rgb(0), material.evaluate(turned(sample.directions.wi, noise.misalignment * ofLight),
                                                         turned(sample.directions.wo, noise.misalignment * ofViewer)));
    Rgb reading, deviation;
    for (int channel = 0; channel < 3; ++channel) {
      deviation[channel] = std::hypot(noise.relative * value[channel], noise.absolute);
      reading[channel] = std::max(0.0, value[channel] + deviation[channel] * gaussian(random));
    }
    measured.rgb.push_back(reading);
    if (isNoisy) measured.noise.push_back(deviation);
  }
  return measured;
}

namespace {

using NoiseColumns = std::array<std::size_t, 3>;

/// r, g, b; or where there are none of these, wavelengths.
io::ColourColumns valueColumns(const io::CsvText& csv) {
  if (!csv.column("r") && !csv.column("g") && !csv.column("b"))
    if (io::ColourColumns spectrum = io::wavelengthColumns(csv); !spectrum.empty()) return spectrum;
  return io::rgbColumns(csv);
}

/// The columns of the standard deviations: one for each channel, or one for all; none if there are none.
std::optional<NoiseColumns> noiseColumns(const io::CsvText& csv) {
  if (const auto all = csv.column("noise")) return NoiseColumns{*all, *all, *all};
  if (!csv.column("noise_r") && !csv.column("noise_g") && !csv.column("noise_b")) return std::nullopt;
  return NoiseColumns{csv.requiredColumn("noise_r"), csv.requiredColumn("noise_g"), csv.requiredColumn("noise_b")};
}

double notNegative(const io::CsvText& csv, const io::CsvText::Row& row, std::size_t column) {
  const double value = csv.number(row, column);
  if (value < 0)
    throw Error(io::lineText(row) + ": found " + numberText(value) + " for " + csv.names[column] +
                ", expected a number, 0 or more");
  return value;
}

Rgb valueOf(const io::CsvText& csv, const io::CsvText::Row& row, const io::ColourColumns& values) {
  for (const std::size_t column : values.columns) notNegative(csv, row, column);
  // A colour outside sRGB has a negative channel.
  return glm::max(values.value(csv, row), Rgb(0));
}

/// One column for all is the noise of each field: their errors are independent.
Rgb noiseOf(const io::CsvText& csv, const io::CsvText::Row& row, const NoiseColumns& noise,
            const io::ColourColumns& values) {
  if (noise[0] != noise[1])
    return {notNegative(csv, row, noise[0]), notNegative(csv, row, noise[1]), notNegative(csv, row, noise[2])};
  Rgb squares(0);
  for (const Rgb& weight : values.weights) squares += weight * weight;
  return notNegative(csv, row, noise[0]) * glm::sqrt(squares);
}

/// Which row is that of each sample.
std::vector<const io::CsvText::Row*> rowsOf(const io::CsvText& csv, const SamplingPlan& plan) {
  const std::size_t column = csv.requiredColumn("index");
  std::map<int, const io::CsvText::Row*> byIndex;
  for (const auto& sample : plan.samples) byIndex[sample.index] = nullptr;
  for (const io::CsvText::Row& row : csv.rows) {
    const int index = csv.integer(row, column);
    const auto found = byIndex.find(index);
    if (found == byIndex.end())
      throw Error(io::lineText(row) + ": found the index " + std::to_string(index) + ", expected an index of the plan");
    if (found->second)
      throw Error(io::lineText(row) + ": found the index " + std::to_string(index) + " a second time (first in " +
                  io::lineText(*found->second) + "), expected each index once");
    found->second = &row;
  }
  std::vector<const io::CsvText::Row*> rows;
  std::string missing;
  for (const auto& sample : plan.samples)
    if (!rows.emplace_back(byIndex[sample.index]))
      missing += (missing.empty() ? "" : ", ") + std::to_string(sample.index);
  if (!missing.empty()) throw Error("found no row for index " + missing + ", expected one for each sample of the plan");
  return rows;
}

}  // namespace

std::string valuesCsv(const SamplingPlan& plan, const MeasuredValues& values) {
  const bool hasNoise = !values.noise.empty();
  io::CsvWriter csv;
  csv.texts({"index", "r", "g", "b"});
  if (hasNoise) csv.texts({"noise_r", "noise_g", "noise_b"});
  csv.endLine();
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    csv.integer(plan.samples[i].index).colour(values.rgb[i]);
    if (hasNoise) csv.colour(values.noise[i]);
    csv.endLine();
  }
  return csv.str();
}

void writeValues(const SamplingPlan& plan, const MeasuredValues& values, const std::filesystem::path& path) {
  checkMeasured(plan, values);
  io::writeFileAtomically(path, valuesCsv(plan, values));
}

MeasuredValues parseValues(std::string_view text, const SamplingPlan& plan) {
  const io::CsvText csv = io::readCsvText(text);
  const io::ColourColumns columns = valueColumns(csv);
  const std::optional<NoiseColumns> noise = noiseColumns(csv);
  MeasuredValues values;
  for (const io::CsvText::Row* row : rowsOf(csv, plan)) {
    values.rgb.push_back(valueOf(csv, *row, columns));
    if (noise) values.noise.push_back(noiseOf(csv, *row, *noise, columns));
  }
  return values;
}

MeasuredValues readValues(const std::filesystem::path& path, const SamplingPlan& plan) {
  return withFileInErrors(path, [&] { return parseValues(io::readText(path), plan); });
}

}  // namespace gonio::acquisition
