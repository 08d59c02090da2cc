// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/brdf.h"
#include "core/coordinates/coordinate_systems.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

/// Pairs of directions by their coordinates, as in the file: angles in degrees.
struct DirectionTable {
  const CoordinateSystem& system;
  std::vector<std::vector<double>> rows;  ///< one value per column of the system

  /// None where no pair above the horizon has the coordinates.
  std::vector<std::optional<DirectionPair>> pairs() const;
};

std::vector<std::optional<DirectionPair>> DirectionTable::pairs() const {
  const bool isStandard = &system == &coordinateSystems().front();
  std::vector<std::optional<DirectionPair>> result;
  for (std::vector<double> row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      if (system.columns[c].isAngle) row[c] = radians(row[c]);
    // Below the horizon, a BRDF has its own answer.
    result.push_back(isStandard ? DirectionPair{fromSpherical(row[0], row[1]), fromSpherical(row[2], row[3])}
                                : system.from(row));
  }
  return result;
}

/// Reads a CSV file (core/io/csv_text.h) with the columns of the coordinates. The first line contains the names (in any
/// order, further columns are ignored); without names the columns have the order of the system.
/// @throws Error that names the file, the line, what was found and what was expected.
DirectionTable readDirections(const std::filesystem::path& path, const CoordinateSystem& system) {
  return withFileInErrors(path, [&] {
    std::vector<std::string_view> names;
    for (const CoordinateColumn& column : system.columns) names.push_back(column.name);
    const io::CsvText csv = io::readCsvText(io::readText(path), names);
    std::vector<std::size_t> columns;
    columns.reserve(names.size());
    for (const std::string_view name : names) columns.push_back(csv.requiredColumn(name));
    DirectionTable table{system, {}};
    for (const io::CsvText::Row& row : csv.rows) {
      std::vector<double> values;
      values.reserve(columns.size());
      for (const std::size_t column : columns) values.push_back(csv.number(row, column));
      table.rows.push_back(std::move(values));
    }
    if (table.rows.empty()) throw Error("contains no directions");
    return table;
  });
}

/// The columns of the file, the four angles in degrees (unless they are those columns), then r, g, b in 1/sr, all with
/// all digits; empty where no pair of directions has the coordinates.
std::string valuesCsv(const DirectionTable& directions, const std::vector<std::optional<DirectionPair>>& pairs,
                      const std::vector<Rgb>& values) {
  const CoordinateSystem& standard = coordinateSystems().front();
  const bool isStandard = &directions.system == &standard;
  io::CsvWriter csv;
  for (const CoordinateColumn& column : directions.system.columns) csv.text(column.name);
  if (!isStandard)
    for (const CoordinateColumn& column : standard.columns)
      // Half-out coordinates contain theta_o, too.
      if (std::ranges::find(directions.system.columns, column.name, &CoordinateColumn::name) ==
          directions.system.columns.end())
        csv.text(column.name);
  csv.texts({"r", "g", "b"}).endLine();
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (const double value : directions.rows[i]) csv.number(value);
    if (!isStandard) {
      std::vector<double> angles(standard.columns.size(), std::nan(""));
      if (pairs[i]) angles = standard.to(*pairs[i]);
      for (std::size_t c = 0; c < angles.size(); ++c)
        if (std::ranges::find(directions.system.columns, standard.columns[c].name, &CoordinateColumn::name) ==
            directions.system.columns.end())
          csv.number(degrees(angles[c]));
    }
    csv.colour(values[i]).endLine();
  }
  return csv.str();
}

struct EvaluateArguments {
  std::string material, directions, out, coordinates{coordinateSystems().front().id};
  bool asStored = false;
  double wavelength = 0;
};

int evaluate(const EvaluateArguments& options, const Tool& tool) {
  const auto material = openAtWavelength(options.material, options.wavelength, tool.control("reading"));
  const DirectionTable directions = readDirections(options.directions, coordinateSystemNamed(options.coordinates));
  const std::vector<std::optional<DirectionPair>> found = directions.pairs();
  std::vector<DirectionPair> pairs;
  pairs.reserve(found.size());
  for (const std::optional<DirectionPair>& pair : found)
    pairs.push_back(pair.value_or(DirectionPair{{0, 0, 1}, {0, 0, 1}}));
  std::vector<Rgb> values(pairs.size());
  const auto brdf = options.asStored ? withIncident(material, IncidentDirection::light) : material;
  const auto start = std::chrono::steady_clock::now();
  brdf->evaluate(pairs, values);
  const double seconds = secondsSince(start);
  tool.throwIfStopped();
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!found[i]) values[i] = Rgb(std::nan(""));
  const auto missing = std::size_t(std::ranges::count_if(found, [](const auto& pair) { return !pair; }));
  io::writeFileAtomically(options.out, valuesCsv(directions, found, values));
  const double evaluationNs = seconds * 1e9 / double(values.size());
  Json json{{"evaluated", values.size() - missing},
            {"seconds", seconds},
            {"evaluationNs", evaluationNs},
            {"coordinates", options.coordinates},
            {"out", options.out}};
  std::string text = options.out + ": " + std::to_string(values.size() - missing) + " values, " + number(evaluationNs) +
                     " ns per evaluation\n";
  if (missing > 0) {
    json["withoutDirections"] = missing;
    text +=
        std::to_string(missing) + " rows are empty: no pair of directions above the horizon has these coordinates\n";
  }
  print(tool, json, text);
  return 0;
}

}  // namespace

void addEvaluate(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Evaluates the BRDF at given directions");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command
      ->add_option("--directions", options->directions,
                   "CSV file with the columns of the coordinates, angles in degrees: theta_i, phi_i, theta_o, phi_o")
      ->type_name("FILE")
      ->required();
  std::vector<std::string> systems;
  for (const CoordinateSystem& system : coordinateSystems()) systems.emplace_back(system.id);
  command
      ->add_option(
          "--coordinates", options->coordinates,
          "Coordinates of the directions: standard; half-difference (theta_h, theta_d, phi_d); half-out (theta_o, "
          "theta_h, phi_h); projected-deviation (theta_r, deviation, phi) (standard)")
      ->check(CLI::IsMember(systems));
  command->add_option("--out", options->out, "CSV file to write: the directions, then the BRDF values r, g, b in 1/sr")
      ->group(outputGroup)
      ->required();
  command->add_flag(
      "--as-stored", options->asStored,
      "Interpret the incident direction of an RGL or UTIA file as that of the light (default: that of the viewer)");
  command->add_option("--wavelength", options->wavelength, wavelengthHelp)->check(CLI::Range(1.0, 1e6));
  command->callback([options, &tool] { tool.run = [options, &tool] { return evaluate(*options, tool); }; });
}

}  // namespace gonio::tool
