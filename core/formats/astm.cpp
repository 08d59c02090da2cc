// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "core/formats/formats.h"
#include "core/formats/scattered_samples.h"
#include "core/io/byte_source.h"
#include "core/io/csv_text.h"
#include "core/io/text_lines.h"
#include "core/math/colour.h"
#include "core/support/text.h"

/// Text files similar to ASTM E1392 (Standard Practice for Angle Resolved Optical Scatter Measurements, 1996), such as
/// the reflectance data of Cornell University's Program of Computer Graphics: lines with a key and text, among them
/// NUM_POINTS, up to VARS with the names of the columns; then one line per point, as a CSV table (io::CsvText).
///
///     NUM_POINTS 2
///     VARS theta_i,phi_i,theta_s,phi_s,R,G,B
///     0.5,0,0.5,3.14159,0.31,0.30,0.28
///
/// Angles: polar angle from the normal and azimuth, of the direction to the light (theta_i, phi_i; phi_i is 0 if
/// missing) and of the scattered light (theta_s, phi_s; also _r, _o, _v). A name may state the unit: "theta_i [deg]",
/// "theta_i (rad)"; otherwise AngleUnit::guessed(), radians as at Cornell if possible. Values: BRDF in 1/sr, without
/// the cosine: R, G, B (linear sRGB); X, Y, Z (D65 white at Y = 1); three or more wavelengths ("550nm", "0.55um",
/// spectrumWeights()); a column named BRDF, BSDF or value; or a single other column. The last two are read as grey.
/// Several columns that may be the values are refused.
namespace gonio::formats {

namespace {

/// Fields of a table take more memory than their text.
constexpr std::uint64_t maxAstmBytes = 1 << 24;

const std::string expectedAstm = "lines NUM_POINTS and VARS (ASTM E1392)";

struct AstmHeader {
  std::optional<io::TextLine> points, variables;
  std::string sample;  ///< what the file says of the sample; may be empty
};

/// Key and text of a line; spreadsheets write them as cells, with empty ones behind.
std::pair<std::string_view, std::string_view> keyOf(std::string_view line) {
  constexpr std::string_view between = " \t,;=:";
  const auto end = std::min(line.find_first_of(between), line.size());
  const auto begin = std::min(line.find_first_not_of(between, end), line.size());
  const auto last = line.find_last_not_of(between);
  return {line.substr(0, end), last == std::string_view::npos ? "" : line.substr(begin, last + 1 - begin)};
}

AstmHeader readAstmHeader(std::string_view text) {
  AstmHeader header;
  io::TextLines lines(text);
  while (const auto line = lines.next()) {
    const auto [key, rest] = keyOf(line->text);
    if (key == "NUM_POINTS") header.points = line;
    if (header.sample.empty() && key.find("SAMPLE") != std::string_view::npos) header.sample = std::string(rest);
    if (key != "VARS") continue;
    header.variables = line;
    break;
  }
  if (!header.points || !header.variables) throw io::FormatMismatch("a text file of another format", expectedAstm);
  return header;
}

std::size_t pointsOf(const AstmHeader& header) {
  const auto count = io::finiteNumber(keyOf(header.points->text).second);
  if (!count || !(*count >= 1 && *count <= 1e9) || *count != std::floor(*count))
    header.points->fail("NUM_POINTS and a whole number, 1 or more");
  return std::size_t(*count);
}

/// The name of a column without its unit, and the unit: "theta_i [deg]" is {"theta_i", "deg"}.
std::pair<std::string, std::string> nameAndUnit(const std::string& name) {
  const std::size_t begin = name.find_last_of("[(");
  if (begin == std::string::npos || begin == 0 || name.find_first_of("])", begin) != name.size() - 1) return {name, ""};
  const std::size_t end = name.find_last_not_of(' ', begin - 1);
  return {name.substr(0, end + 1), name.substr(begin + 1, name.size() - begin - 2)};
}

std::string quotedNames(const io::CsvText& csv, const std::vector<std::size_t>& columns) {
  std::string text;
  for (const std::size_t column : columns) text += (text.empty() ? "'" : ", '") + csv.names[column] + "'";
  return text;
}

/// The columns of a table by their names without units.
class Columns {
 public:
  explicit Columns(const io::CsvText& csv) : csv_(csv) {
    for (const std::string& name : csv.names) parts_.push_back(nameAndUnit(name));
  }

  /// The column with one of the names. @throws Error if there are several.
  std::optional<std::size_t> find(std::initializer_list<std::string_view> names) const {
    std::vector<std::size_t> found;
    for (std::size_t column = 0; column < parts_.size(); ++column)
      if (std::ranges::find(names, parts_[column].first) != names.end()) found.push_back(column);
    if (found.size() > 1) fail("the columns " + quotedNames(csv_, found), "only one of them");
    return found.empty() ? std::nullopt : std::optional(found[0]);
  }
  const std::string& unit(std::size_t column) const { return parts_[column].second; }
  const std::string& name(std::size_t column) const { return parts_[column].first; }
  const io::CsvText& csv() const { return csv_; }
  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    throw Error("line " + std::to_string(csv_.headerLine) + ": found " + found + ", expected " + expected);
  }

 private:
  const io::CsvText& csv_;
  std::vector<std::pair<std::string, std::string>> parts_;
};

/// theta_i, phi_i, theta_s, phi_s; phi_i may be missing.
struct AngleColumns {
  std::array<std::optional<std::size_t>, 4> columns;

  explicit AngleColumns(const Columns& all)
      : columns{all.find({"theta_i"}), all.find({"phi_i"}), all.find({"theta_s", "theta_r", "theta_o", "theta_v"}),
                all.find({"phi_s", "phi_r", "phi_o", "phi_v"})} {
    for (const auto& [column, name] :
         {std::pair(columns[0], "theta_i"), {columns[2], "theta_s"}, {columns[3], "phi_s"}})
      if (!column) all.csv().requiredColumn(name);
  }
  bool contains(std::size_t column) const { return std::ranges::find(columns, column) != columns.end(); }
  std::array<double, 4> at(const io::CsvText& csv, const io::CsvText::Row& row) const {
    std::array<double, 4> angles{};
    for (std::size_t i = 0; i < 4; ++i)
      if (columns[i]) angles[i] = csv.number(row, *columns[i]);
    return angles;
  }
};

/// The columns of values, and what they are for notes.
struct Values {
  io::ColourColumns colours;
  std::string text;
};

/// Whether a column cannot hold BRDF values, by its name.
bool isOtherQuantity(std::string_view name) {
  for (const std::string_view part : {"wave", "lambda", "theta", "phi", "index", "number", "time", "date", "noise",
                                      "sigma", "error", "std", "dev", "polari", "btdf", "cos", "dsf"})
    if (name.find(part) != std::string_view::npos && name != "bsdf") return true;
  return name == "n" || name == "id" || name == "no" || name == "nm" || name == "um";
}

constexpr const char* valueChoices =
    "R, G, B; X, Y, Z; three or more wavelengths (such as 450nm or 0.45um); or one column named BRDF, used as grey";

Values valuesOf(const Columns& columns, const AngleColumns& angles) {
  const io::CsvText& csv = columns.csv();
  const auto three = [&](std::string_view a, std::string_view b, std::string_view c) {
    return std::array{columns.find({a}), columns.find({b}), columns.find({c})};
  };
  const auto rgb = three("r", "g", "b"), xyz = three("x", "y", "z");
  if (rgb[0] || rgb[1] || rgb[2]) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!rgb[i]) csv.requiredColumn(std::string_view("rgb").substr(i, 1));
    return {{{*rgb[0], *rgb[1], *rgb[2]}, {Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1)}}, "R, G, B (linear sRGB)"};
  }
  if (xyz[0] && xyz[1] && xyz[2])
    return {{{*xyz[0], *xyz[1], *xyz[2]}, {linearSrgb({1, 0, 0}), linearSrgb({0, 1, 0}), linearSrgb({0, 0, 1})}},
            "X, Y, Z (white of D65 at Y = 1)"};
  if (io::ColourColumns spectrum = io::wavelengthColumns(csv); !spectrum.empty()) {
    const std::string text = std::to_string(spectrum.columns.size()) + " wavelengths, " +
                             quotedNames(csv, {spectrum.columns.front()}) + " to " +
                             quotedNames(csv, {spectrum.columns.back()});
    return {std::move(spectrum), text};
  }
  std::vector<std::size_t> others;
  for (std::size_t column = 0; column < csv.names.size(); ++column)
    if (!angles.contains(column)) others.push_back(column);
  if (others.empty()) columns.fail("no column of values", valueChoices);
  const auto named = columns.find({"brdf", "bsdf", "value"});
  if (!named && (others.size() > 1 || isOtherQuantity(columns.name(others[0]))))
    columns.fail("the columns " + quotedNames(csv, others) + " beside the angles", valueChoices);
  const std::size_t column = named.value_or(others[0]);
  return {{{column}, {Rgb(1)}}, quotedNames(csv, {column}) + " as grey"};
}

/// A note of the columns that are not read. @throws Error if one of them is a wavelength that differs between rows.
void noteOtherColumns(const Columns& columns, const AngleColumns& angles, const Values& values,
                      std::vector<std::string>& notes) {
  const io::CsvText& csv = columns.csv();
  std::vector<std::size_t> others;
  for (std::size_t column = 0; column < csv.names.size(); ++column) {
    if (angles.contains(column) || std::ranges::count(values.colours.columns, column) > 0) continue;
    others.push_back(column);
    if (columns.name(column).find("wave") == std::string::npos &&
        columns.name(column).find("lambda") == std::string::npos)
      continue;
    for (const io::CsvText::Row& row : csv.rows)
      if (row.fields[column] != csv.rows[0].fields[column])
        throw Error(io::lineText(row) + ": found " + row.fields[column] + " for " + csv.names[column] + " after " +
                    csv.rows[0].fields[column] +
                    ", expected one wavelength, or a column of values for each (such as 450nm)");
  }
  if (!others.empty()) notes.push_back("columns that are not used: " + quotedNames(csv, others));
}

/// The unit that the names of the columns of angles state; empty: none. @throws Error if they state two or another one.
std::optional<AngleUnit> statedUnit(const Columns& columns, const AngleColumns& angles) {
  std::optional<AngleUnit> result;
  for (const auto& column : angles.columns) {
    if (!column || columns.unit(*column).empty()) continue;
    const std::string& unit = columns.unit(*column);
    const bool isDegrees = unit.starts_with("deg") || unit == "\u00b0";
    if (!isDegrees && !unit.starts_with("rad"))
      columns.fail("the unit of '" + columns.csv().names[*column] + "'", "[deg] or [rad]");
    const AngleUnit found = isDegrees ? AngleUnit{gonio::radians(1), "degrees"} : AngleUnit{};
    if (result && result->name != found.name) columns.fail("angles in two units", "all in degrees or all in radians");
    result = found;
  }
  return result;
}

void sniffAstm(const io::ByteSource& source) { readAstmHeader(io::textHead(source, expectedAstm)); }

constexpr std::string_view astmSuffixes[] = {".astm"};

}  // namespace

ScatteredSamples readAstm(const io::ByteSource& source) {
  const std::string text = io::allText(source, maxAstmBytes);
  const AstmHeader header = readAstmHeader(text);
  const std::string_view names = keyOf(header.variables->text).second;
  const io::CsvText csv = io::readCsvText(std::string_view(text).substr(std::size_t(names.data() - text.data())), {},
                                          header.variables->number);
  if (csv.rows.size() != pointsOf(header))
    header.points->fail("NUM_POINTS " + std::to_string(csv.rows.size()) + ", the number of rows");
  const Columns columns(csv);
  const AngleColumns angles(columns);
  const Values values = valuesOf(columns, angles);
  std::vector<std::array<double, 4>> rows;
  for (const io::CsvText::Row& row : csv.rows) rows.push_back(angles.at(csv, row));
  const auto stated = statedUnit(columns, angles);
  const AngleUnit unit =
      stated ? *stated : AngleUnit::guessed(rows, "name a column 'theta_i [deg]' or 'theta_i [rad]'");
  ScatteredSamples samples;
  samples.description = header.sample;
  samples.notes.push_back("read as: angles in " + std::string(unit.name) +
                          (stated ? "" : " (the file states no unit)") + (angles.columns[1] ? "" : ", phi_i 0") + "; " +
                          values.text + " in 1/sr; " + csv.notationText());
  noteOtherColumns(columns, angles, values, samples.notes);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto& [thetaI, phiI, thetaS, phiS] = rows[i];
    samples.add({fromSpherical(unit.radians * thetaI, unit.radians * phiI),
                 fromSpherical(unit.radians * thetaS, unit.radians * phiS)},
                values.colours.value(csv, csv.rows[i]));
  }
  return samples;
}

constinit const MaterialFormat astmFormat{.name = "ASTM",
                                          .label = "ASTM E1392 samples",
                                          .suffixes = astmSuffixes,
                                          .sniff = sniffAstm,
                                          .read = readScattered<readAstm>};

}  // namespace gonio::formats
