// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/sgd_library.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <map>

#include "core/io/sha256.h"
#include "core/models/parameters_json.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

/// Columns of the table that are called otherwise than the parameter.
std::string columnOf(std::string_view parameterId, int channel) {
  const std::string name = parameterId == "diffuse"    ? "rhoD"
                           : parameterId == "specular" ? "rhoS"
                                                       : std::string(parameterId);
  return name + std::array{"_r", "_g", "_b"}[std::size_t(channel)];
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

/// One line of the table, looked up by the names of the columns.
class Row {
 public:
  Row(const std::map<std::string, std::size_t, std::less<>>& columns, std::string_view line, std::size_t number)
      : columns_(columns), cells_(split(line, ',')), number_(number) {}

  std::string_view cell(const std::string& column) const {
    const auto found = columns_.find(column);
    if (found == columns_.end() || found->second >= cells_.size()) fail(column, "nothing");
    return cells_[found->second];
  }
  double number(const std::string& column) const {
    const std::string_view text = cell(column);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) fail(column, "'" + std::string(text) + "'");
    return value;
  }

 private:
  [[noreturn]] void fail(const std::string& column, const std::string& found) const {
    throw Error("line " + std::to_string(number_) + ", column " + column + ": found " + found + ", expected a value");
  }

  const std::map<std::string, std::size_t, std::less<>>& columns_;
  std::vector<std::string_view> cells_;
  std::size_t number_;
};

}  // namespace

std::string SgdFit::description() const { return "SGD fit of MERL " + name + ", Bagher et al. 2012"; }

std::string SgdFit::sha256() const {
  return io::sha256Hex(std::string_view(models::parametersToJson(models::findModel("sgd").spec(), parameters).dump()));
}

std::vector<SgdFit> parseSgdFigures(std::string_view csv) {
  const models::ModelSpec& spec = models::findModel("sgd").spec();
  const std::vector<std::string_view> lines = split(csv, '\n');
  std::map<std::string, std::size_t, std::less<>> columns;
  for (const std::string_view name : split(lines.front(), ',')) columns.emplace(name, columns.size());
  std::vector<SgdFit> fits;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    if (lines[i].empty()) continue;
    const Row row(columns, lines[i], i + 1);
    SgdFit fit{std::string(row.cell("material")), {}};
    for (const models::ParameterSpec& parameter : spec.parameters) {
      Rgb& value = fit.parameters.values.emplace_back(0);
      for (int channel = 0; channel < 3; ++channel) value[channel] = row.number(columnOf(parameter.id, channel));
    }
    fits.push_back(std::move(fit));
  }
  return fits;
}

const std::vector<SgdFit>& sgdFits() {
  static const std::vector<SgdFit> fits = parseSgdFigures(sgdFigures());
  return fits;
}

Material sgdMaterial(const SgdFit& fit) {
  const models::Model& model = models::findModel("sgd");
  Material material;
  material.name = fit.name;
  material.brdf = model.instantiate(fit.parameters);
  material.source.format = sgdFormat;
  material.source.sha256 = fit.sha256();
  material.source.description = fit.description();
  return material;
}

}  // namespace gonio::materials
