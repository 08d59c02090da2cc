// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/values_file.h"

#include <array>
#include <map>
#include <optional>

#include "core/io/atomic_file.h"
#include "core/io/byte_source.h"
#include "core/io/csv_text.h"
#include "core/support/naming_file.h"
#include "core/support/number_text.h"

namespace gonio::io {

namespace {

using acquisition::MeasuredValues;
using acquisition::SamplingPlan;

constexpr std::uint64_t mostBytes = 1 << 24;
using Columns = std::array<std::size_t, 3>;

Columns valueColumns(const CsvText& csv) {
  return {csv.neededColumn("r"), csv.neededColumn("g"), csv.neededColumn("b")};
}

/// Of each channel its own, or one for all.
std::optional<Columns> noiseColumns(const CsvText& csv) {
  if (const auto all = csv.column("noise")) return Columns{*all, *all, *all};
  if (!csv.column("noise_r") && !csv.column("noise_g") && !csv.column("noise_b")) return std::nullopt;
  return Columns{csv.neededColumn("noise_r"), csv.neededColumn("noise_g"), csv.neededColumn("noise_b")};
}

Rgb rgbOf(const CsvText& csv, const CsvText::Row& row, const Columns& columns) {
  Rgb value;
  for (int channel = 0; channel < 3; ++channel) {
    const std::size_t column = columns[std::size_t(channel)];
    value[channel] = csv.number(row, column);
    if (value[channel] < 0)
      throw Error(lineText(row) + ": found " + numberText(value[channel]) + " for " + csv.names[column] +
                  ", expected a number, 0 or more");
  }
  return value;
}

/// Which row is that of each sample.
std::vector<const CsvText::Row*> rowsOf(const CsvText& csv, const SamplingPlan& plan) {
  const std::size_t column = csv.neededColumn("index");
  std::map<int, const CsvText::Row*> byIndex;
  for (const auto& sample : plan.samples) byIndex[sample.index] = nullptr;
  for (const CsvText::Row& row : csv.rows) {
    const int index = csv.integer(row, column);
    const auto found = byIndex.find(index);
    if (found == byIndex.end())
      throw Error(lineText(row) + ": found the index " + std::to_string(index) + ", which the plan does not have");
    if (found->second)
      throw Error(lineText(row) + ": found the index " + std::to_string(index) + " again, first in " +
                  lineText(*found->second));
    found->second = &row;
  }
  std::vector<const CsvText::Row*> rows;
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
  writeFileAtomically(path, valuesCsv(plan, values));
}

MeasuredValues parseValues(std::string_view text, const SamplingPlan& plan) {
  const CsvText csv = readCsvText(text);
  const Columns columns = valueColumns(csv);
  const std::optional<Columns> noise = noiseColumns(csv);
  MeasuredValues values;
  for (const CsvText::Row* row : rowsOf(csv, plan)) {
    values.rgb.push_back(rgbOf(csv, *row, columns));
    if (noise) values.noise.push_back(rgbOf(csv, *row, *noise));
  }
  return values;
}

MeasuredValues readValues(const std::filesystem::path& path, const SamplingPlan& plan) {
  return namingFile(path, [&] {
    const std::vector<std::byte> bytes = FileSource(path).readAll(mostBytes);
    return parseValues({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, plan);
  });
}

}  // namespace gonio::io
