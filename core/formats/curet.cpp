// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/text_lines.h"

/// One sample of the CUReT BRDF database (Dana, van Ginneken, Nayar and Koenderink 1999, "Reflectance and Texture of
/// Real-World Surfaces"): ASCII, 205 rows, one per measurement, each with polar angle and azimuth of both directions
/// and its values,
///
///     theta phi theta phi R G B or theta phi theta phi value
///
/// with light and viewer in either order, which are equivalent for a reciprocal material. The unit of the angles is
/// AngleUnit::guessed(); numbers may have decimal commas (io::notationOf()). The database itself has one file per
/// channel with the values of all 61 samples (rbrdf.dat, gbrdf.dat, bbrdf.dat: one row per sample, its number and 205
/// values), and the directions in another table. No single file of it is a material; such files are rejected with an
/// explanation of what to combine. Lines that begin with # are comments.
namespace gonio::formats {

namespace {

constexpr std::size_t measurements = 205, curetAngles = 4;
/// 205 rows of seven numbers in any notation.
constexpr std::uint64_t maxCuretBytes = 1 << 17;
/// Maximum size of the file of one channel: 61 rows of 206 numbers.
constexpr std::uint64_t maxChannelBytes = 1 << 20;

const std::string expectedCuret =
    "205 rows of 5 or 7 numbers: two directions in polar angle and azimuth, then the values";

/// Refuses a text whose first row belongs to the file of one channel.
void refuseChannelFile(const io::TextLine& line) {
  if (io::words(line.text).size() == measurements + 1)
    throw io::FormatMismatch(
        "a CUReT file with one channel (one row per sample, no directions)",
        expectedCuret +
            ". To make such a file, append the values of one sample (the same row of each channel file) as "
            "three columns to the table of directions");
}

struct CuretRows {
  std::vector<std::vector<double>> rows;
  io::NumberNotation notation;
};

CuretRows rowsOf(const io::ByteSource& source) {
  const std::string head = io::textHead(source, expectedCuret);
  io::TextLines first(head);
  if (const auto line = first.next(); line && source.size() <= maxChannelBytes) refuseChannelFile(*line);
  if (source.size() > maxCuretBytes)
    throw io::FormatMismatch("text of " + std::to_string(source.size()) + " bytes", expectedCuret);
  const std::string text = io::allText(source, maxCuretBytes);
  CuretRows result{{}, io::notationOf(text)};
  auto& rows = result.rows;
  const io::NumberNotation& notation = result.notation;
  if (!notation.ambiguity.empty())
    throw io::FormatMismatch("numbers in an unclear notation: " + notation.ambiguity, expectedCuret);
  io::TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::vector<std::string_view> fields = io::words(io::withoutComment(line->text), notation);
    if (fields.empty()) continue;
    const std::size_t columns = rows.empty() ? fields.size() : rows[0].size();
    if (fields.size() != columns || (columns != curetAngles + 1 && columns != curetAngles + 3) ||
        !std::ranges::all_of(fields,
                             [&](std::string_view field) { return io::finiteNumber(field, notation).has_value(); }))
      throw io::FormatMismatch("line " + std::to_string(line->number) + ", which has another layout", expectedCuret);
    rows.push_back(io::finiteNumbers(*line, notation));
  }
  if (rows.size() != measurements)
    throw io::FormatMismatch(std::to_string(rows.size()) + " rows of numbers", expectedCuret);
  return result;
}

void sniffCuret(const io::ByteSource& source) { rowsOf(source); }

constexpr std::string_view curetSuffixes[] = {".dat"};

}  // namespace

ScatteredSamples readCuret(const io::ByteSource& source) {
  const auto [rows, notation] = rowsOf(source);
  std::vector<std::array<double, curetAngles>> directions;
  directions.reserve(rows.size());
  for (const std::vector<double>& row : rows) directions.push_back({row[0], row[1], row[2], row[3]});
  const AngleUnit unit = AngleUnit::guessed(directions, "write all angles in degrees, such as 90 for a quarter turn");
  ScatteredSamples samples;
  samples.notes.push_back(
      "read as: angles in " + std::string(unit.name) + " (the file states no unit); BRDF in 1/sr as " +
      (rows[0].size() == curetAngles + 1 ? "grey" : "R, G, B (linear sRGB)") + "; " + notation.text());
  for (const std::vector<double>& row : rows)
    samples.add({fromSpherical(unit.radians * row[0], unit.radians * row[1]),
                 fromSpherical(unit.radians * row[2], unit.radians * row[3])},
                row.size() == curetAngles + 1 ? Rgb(row[curetAngles])
                                              : Rgb(row[curetAngles], row[curetAngles + 1], row[curetAngles + 2]));
  return samples;
}

constinit const MaterialFormat curetFormat{.name = "CUReT",
                                           .label = "CUReT samples",
                                           .suffixes = curetSuffixes,
                                           .isSuffixAmbiguous = true,
                                           .sniff = sniffCuret,
                                           .read = readScattered<readCuret>};

}  // namespace gonio::formats
