// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/direction_table.h"

#include <array>

#include "core/io/csv_table.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"

namespace gonio::tool {

namespace {

constexpr std::array<std::string_view, 4> columnNames = {"theta_i", "phi_i", "theta_o", "phi_o"};

}  // namespace

std::vector<DirectionPair> DirectionTable::pairs() const {
  std::vector<DirectionPair> result;
  for (const Row& row : rows)
    result.push_back(
        {fromSpherical(radians(row.thetaI), radians(row.phiI)), fromSpherical(radians(row.thetaO), radians(row.phiO))});
  return result;
}

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

std::string valuesCsv(const DirectionTable& directions, const std::vector<Rgb>& values) {
  io::CsvWriter csv;
  csv.texts({"theta_i", "phi_i", "theta_o", "phi_o", "r", "g", "b"}).endLine();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DirectionTable::Row& row = directions.rows[i];
    csv.number(row.thetaI).number(row.phiI).number(row.thetaO).number(row.phiO).colour(values[i]).endLine();
  }
  return csv.str();
}

}  // namespace gonio::tool
