// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/formats/point_table.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <numeric>
#include <optional>

#include "core/math/colour.h"

namespace gonio::formats {

namespace {

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

std::string allNames(const io::CsvText& csv) {
  std::vector<std::size_t> all(csv.names.size());
  std::iota(all.begin(), all.end(), std::size_t(0));
  return quotedNames(csv, all);
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
  bool isDifference = false;  ///< whether the last one is the azimuth from that of the light

  explicit AngleColumns(const Columns& all) : columns{polar(all, 0), all.find({"phi_i", "phi_in"}), polar(all, 2), {}} {
    const auto azimuth = all.find({"phi_s", "phi_r", "phi_o", "phi_v", "phi_out"}),
               difference = all.find({"dphi", "delta_phi"});
    if (azimuth && difference)
      all.fail("the columns " + quotedNames(all.csv(), {*azimuth, *difference}), "only one of them");
    columns[3] = azimuth ? azimuth : difference;
    isDifference = difference.has_value();
    for (const auto& [column, name] : {std::pair(columns[0], "theta_i"),
                                       {columns[2], "theta_s (or theta_o, theta_r)"},
                                       {columns[3], "phi_s (or phi_o, phi_r, dphi)"}})
      if (!column) all.fail("the columns " + allNames(all.csv()), std::string("one named ") + name);
  }
  static std::optional<std::size_t> polar(const Columns& all, std::size_t angle) {
    return angle == 0 ? all.find({"theta_i", "theta_in"})
                      : all.find({"theta_s", "theta_r", "theta_o", "theta_v", "theta_out"});
  }
  bool contains(std::size_t column) const { return std::ranges::find(columns, column) != columns.end(); }
  /// In the unit of the file.
  std::array<double, 4> at(const io::CsvText& csv, const io::CsvText::Row& row) const {
    std::array<double, 4> angles{};
    for (std::size_t i = 0; i < 4; ++i)
      if (columns[i]) angles[i] = csv.number(row, *columns[i]);
    if (isDifference) angles[3] += angles[1];
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
  const std::array rgb{columns.find({"r", "red"}), columns.find({"g", "green"}), columns.find({"b", "blue"})},
      xyz{columns.find({"x"}), columns.find({"y"}), columns.find({"z"})};
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
    // The degree sign in UTF-8, or in Windows-1252, as some spreadsheets write.
    const bool isDegrees = unit.starts_with("deg") || unit == "\u00b0" || unit == "\xb0";
    if (!isDegrees && !unit.starts_with("rad"))
      columns.fail("the unit of '" + columns.csv().names[*column] + "'", "[deg] or [rad]");
    const AngleUnit found = isDegrees ? AngleUnit{gonio::radians(1), "degrees"} : AngleUnit{};
    if (result && result->name != found.name) columns.fail("angles in two units", "all in degrees or all in radians");
    result = found;
  }
  return result;
}

}  // namespace

bool hasPolarAngles(const io::CsvText& csv) {
  const Columns columns(csv);
  return AngleColumns::polar(columns, 0) && AngleColumns::polar(columns, 2);
}

ScatteredSamples readPointTable(const io::CsvText& csv, DefaultUnit defaultUnit) {
  constexpr const char* unitChoice = "name a column 'theta_i [deg]' or 'theta_i [rad]'";
  const Columns columns(csv);
  const AngleColumns angles(columns);
  const Values values = valuesOf(columns, angles);
  std::vector<std::array<double, 4>> rows;
  for (const io::CsvText::Row& row : csv.rows) rows.push_back(angles.at(csv, row));
  const auto stated = statedUnit(columns, angles);
  const AngleUnit unit = stated                                ? *stated
                         : defaultUnit == DefaultUnit::guessed ? AngleUnit::guessed(rows, unitChoice)
                                                               : AngleUnit::degreesUnlessRadians(rows, unitChoice);
  ScatteredSamples samples;
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

}  // namespace gonio::formats
