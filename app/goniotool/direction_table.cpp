// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "app/goniotool/direction_table.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

#include "core/support/error.h"

namespace gonio::tool {

namespace {

constexpr std::array<std::string_view, 4> columnNames = {"theta_i", "phi_i", "theta_o", "phi_o"};

std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r\""), end = text.find_last_not_of(" \t\r\"");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(trimmed(field));
  return fields;
}

std::optional<double> toNumber(const std::string& text) {
  double value = 0;
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

using Columns = std::array<std::size_t, columnNames.size()>;

/// Where the columns stand, of a line of names.
Columns columnsOf(const std::vector<std::string>& names, const std::string& where) {
  Columns columns;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto found = std::find(names.begin(), names.end(), columnNames[c]);
    if (found == names.end())
      throw Error(where + ": found no column " + std::string(columnNames[c]) +
                  ", expected theta_i, phi_i, theta_o, phi_o (degrees)");
    columns[c] = std::size_t(found - names.begin());
  }
  return columns;
}

}  // namespace

std::vector<DirectionPair> DirectionTable::pairs() const {
  std::vector<DirectionPair> result;
  for (const Row& row : rows)
    result.push_back(
        {fromSpherical(radians(row.thetaI), radians(row.phiI)), fromSpherical(radians(row.thetaO), radians(row.phiO))});
  return result;
}

DirectionTable readDirections(const std::filesystem::path& path) {
  std::ifstream stream(path);
  if (!stream) throw Error(path.string() + ": cannot be opened");
  DirectionTable table;
  Columns columns{0, 1, 2, 3};
  bool isFirst = true;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    if (trimmed(line).empty() || trimmed(line).starts_with('#')) continue;
    const std::vector<std::string> fields = split(line);
    const std::string where = path.string() + ", line " + std::to_string(number);
    if (std::exchange(isFirst, false) && !toNumber(fields[0])) {
      columns = columnsOf(fields, where);
      continue;
    }
    std::array<double, columnNames.size()> angles;
    for (std::size_t c = 0; c < angles.size(); ++c) {
      const std::string found = columns[c] < fields.size() ? fields[columns[c]] : "";
      const std::optional<double> value = toNumber(found);
      if (!value)
        throw Error(where + ": found '" + found + "' for " + std::string(columnNames[c]) + ", expected degrees");
      angles[c] = *value;
    }
    table.rows.push_back({angles[0], angles[1], angles[2], angles[3]});
  }
  if (table.rows.empty()) throw Error(path.string() + ": found no directions");
  return table;
}

std::string valuesCsv(const DirectionTable& directions, const std::vector<Rgb>& values) {
  std::string text = "theta_i,phi_i,theta_o,phi_o,r,g,b\n";
  char buffer[64];
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DirectionTable::Row& row = directions.rows[i];
    const double fields[] = {row.thetaI, row.phiI, row.thetaO, row.phiO, values[i].x, values[i].y, values[i].z};
    for (const double& field : fields) {
      const auto result = std::to_chars(buffer, buffer + sizeof buffer, field);
      text.append(buffer, result.ptr) += &field == std::end(fields) - 1 ? '\n' : ',';
    }
  }
  return text;
}

}  // namespace gonio::tool
