// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/io/curet_file.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/io/format_mismatch.h"
#include "core/io/text_lines.h"

namespace gonio::io {

namespace {

constexpr std::size_t measurements = 205, angles = 4;
/// 205 rows of seven numbers in any notation.
constexpr std::uint64_t maxCuretBytes = 1 << 17;
/// Of one channel: 61 rows of 206 numbers.
constexpr std::uint64_t maxChannelBytes = 1 << 20;
/// Radians end at a full turn; rounded to a few digits.
constexpr double maxCuretRadians = 2 * pi + 0.01;

const std::string expectedCuret =
    "205 rows of 5 or 7 numbers: two directions in polar angle and azimuth, then the values";

/// Of text whose first row is one of a channel's file.
void refuseChannelFile(const TextLine& line) {
  if (words(line.text).size() == measurements + 1)
    throw FormatMismatch(
        "a CUReT file with one channel (one row per sample, no directions)",
        expectedCuret +
            ". To make such a file, append the values of one sample (the same row of each channel file) as "
            "three columns to the table of directions");
}

std::vector<std::vector<double>> rowsOf(const ByteSource& source) {
  const std::string head = textHead(source, expectedCuret);
  std::vector<std::vector<double>> rows;
  TextLines first(head);
  if (const auto line = first.next(); line && source.size() <= maxChannelBytes) refuseChannelFile(*line);
  if (source.size() > maxCuretBytes)
    throw FormatMismatch("text of " + std::to_string(source.size()) + " bytes", expectedCuret);
  const std::string text = allText(source, maxCuretBytes);
  TextLines lines(text);
  while (const auto line = lines.next()) {
    if (line->text.starts_with('#')) continue;
    const std::vector<std::string_view> fields = words(line->text);
    const std::size_t columns = rows.empty() ? fields.size() : rows[0].size();
    if (fields.size() != columns || (columns != angles + 1 && columns != angles + 3) ||
        !std::ranges::all_of(fields, [](std::string_view field) { return finiteNumber(field).has_value(); }))
      throw FormatMismatch("line " + std::to_string(line->number) + ", which has another layout", expectedCuret);
    rows.push_back(finiteNumbers(*line));
  }
  if (rows.size() != measurements)
    throw FormatMismatch(std::to_string(rows.size()) + " rows of numbers", expectedCuret);
  return rows;
}

}  // namespace

void expectCuret(const ByteSource& source) { rowsOf(source); }

ScatteredSamples readCuret(const ByteSource& source) {
  const auto rows = rowsOf(source);
  double unit = 1;
  for (const std::vector<double>& row : rows)
    for (std::size_t i = 0; i < angles; ++i)
      if (std::abs(row[i]) > maxCuretRadians) unit = radians(1);
  ScatteredSamples samples;
  for (const std::vector<double>& row : rows)
    samples.add({fromSpherical(unit * row[0], unit * row[1]), fromSpherical(unit * row[2], unit * row[3])},
                row.size() == angles + 1 ? Rgb(row[angles]) : Rgb(row[angles], row[angles + 1], row[angles + 2]));
  return samples;
}

}  // namespace gonio::io
