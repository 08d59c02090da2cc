// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <array>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "app/goniotool/materials.h"
#include "app/goniotool/report.h"
#include "app/goniotool/tool.h"
#include "core/brdf/brdf.h"
#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

/// Pairs of directions with angles in degrees, as in the file.
struct DirectionTable {
  struct Row {
    double thetaI, phiI, thetaO, phiO;
  };
  std::vector<Row> rows;

  std::vector<DirectionPair> pairs() const;
};

constexpr std::array<std::string_view, 4> columnNames = {"theta_i", "phi_i", "theta_o", "phi_o"};

std::vector<DirectionPair> DirectionTable::pairs() const {
  std::vector<DirectionPair> result;
  for (const Row& row : rows)
    result.push_back(
        {fromSpherical(radians(row.thetaI), radians(row.phiI)), fromSpherical(radians(row.thetaO), radians(row.phiO))});
  return result;
}

/// Reads a CSV file (core/io/csv_text.h) with the columns theta_i, phi_i, theta_o, phi_o. The first line contains the
/// names (in any order, further columns are ignored); without names the columns have this order.
/// @throws Error that names the file, the line, what was found and what was expected.
DirectionTable readDirections(const std::filesystem::path& path) {
  return withFileInErrors(path, [&] {
    const io::CsvText csv = io::readCsvText(io::readText(path), columnNames);
    std::array<std::size_t, columnNames.size()> columns;
    for (std::size_t c = 0; c < columns.size(); ++c) columns[c] = csv.requiredColumn(columnNames[c]);
    DirectionTable table;
    for (const io::CsvText::Row& row : csv.rows)
      table.rows.push_back({csv.number(row, columns[0]), csv.number(row, columns[1]), csv.number(row, columns[2]),
                            csv.number(row, columns[3])});
    if (table.rows.empty()) throw Error("contains no directions");
    return table;
  });
}

/// theta_i, phi_i, theta_o, phi_o, r, g, b: degrees and 1/sr, with all digits.
std::string valuesCsv(const DirectionTable& directions, const std::vector<Rgb>& values) {
  io::CsvWriter csv;
  csv.texts({"theta_i", "phi_i", "theta_o", "phi_o", "r", "g", "b"}).endLine();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DirectionTable::Row& row = directions.rows[i];
    csv.number(row.thetaI).number(row.phiI).number(row.thetaO).number(row.phiO).colour(values[i]).endLine();
  }
  return csv.str();
}

struct EvaluateArguments {
  std::string material, directions, out;
  bool asStored = false;
  double wavelength = 0;
};

int evaluate(const EvaluateArguments& options, const Tool& tool) {
  const auto material = openAtWavelength(options.material, options.wavelength, tool.control("reading"));
  const DirectionTable directions = readDirections(options.directions);
  const std::vector<DirectionPair> pairs = directions.pairs();
  std::vector<Rgb> values(pairs.size());
  const auto brdf = options.asStored ? withIncident(material, IncidentDirection::light) : material;
  const auto start = std::chrono::steady_clock::now();
  brdf->evaluate(pairs, values);
  const double seconds = secondsSince(start);
  tool.throwIfStopped();
  io::writeFileAtomically(options.out, valuesCsv(directions, values));
  const double evaluationNs = seconds * 1e9 / double(values.size());
  print(
      tool, {{"evaluated", values.size()}, {"seconds", seconds}, {"evaluationNs", evaluationNs}, {"out", options.out}},
      options.out + ": " + std::to_string(values.size()) + " values, " + number(evaluationNs) + " ns per evaluation\n");
  return 0;
}

}  // namespace

void addEvaluate(CLI::App& app, Tool& tool) {
  const auto options = std::make_shared<EvaluateArguments>();
  CLI::App* command = app.add_subcommand("evaluate", "Evaluates the BRDF at given directions");
  command->add_option("MATERIAL", options->material, materialHelp)->required();
  command->add_option("--directions", options->directions, "CSV file with theta_i, phi_i, theta_o, phi_o in degrees")
      ->type_name("FILE")
      ->required();
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
