// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/materials/sgd_library.h"

#include <array>

#include "core/io/csv_text.h"
#include "core/io/sha256.h"
#include "core/models/model_brdf.h"
#include "core/models/parameters_json.h"
#include "core/support/error.h"

namespace gonio::materials {

namespace {

/// Columns of the table that are called otherwise than the parameter.
std::string columnOf(std::string_view parameterId, int channel) {
  const std::string name = parameterId == "diffuse"    ? "rhod"
                           : parameterId == "specular" ? "rhos"
                                                       : std::string(parameterId);
  return name + std::array{"_r", "_g", "_b"}[std::size_t(channel)];
}

}  // namespace

std::string SgdFit::description() const { return "SGD fit of MERL " + name + ", Bagher et al. 2012"; }

std::string SgdFit::sha256() const {
  return io::sha256Hex(std::string_view(models::parametersToJson(models::findModel("sgd").spec(), parameters).dump()));
}

std::vector<SgdFit> parseSgdTable(std::string_view text) {
  const models::ModelSpec& spec = models::findModel("sgd").spec();
  const io::CsvText csv = io::readCsvText(text);
  const std::size_t name = csv.requiredColumn("material");
  std::vector<SgdFit> fits;
  for (const io::CsvText::Row& row : csv.rows) {
    SgdFit& fit = fits.emplace_back(SgdFit{row.fields[name], {}});
    for (const models::ParameterSpec& parameter : spec.parameters) {
      Rgb& value = fit.parameters.values.emplace_back(0);
      for (int channel = 0; channel < 3; ++channel)
        value[channel] = csv.number(row, csv.requiredColumn(columnOf(parameter.id, channel)));
    }
  }
  return fits;
}

const std::vector<SgdFit>& sgdFits() {
  static const std::vector<SgdFit> fits = parseSgdTable(sgdTableCsv());
  return fits;
}

Material sgdMaterial(const SgdFit& fit) {
  Material material;
  material.name = fit.name;
  material.brdf = std::make_shared<const models::ModelBrdf>(models::findModel("sgd"), fit.parameters);
  material.source.format = sgdFormat;
  material.source.sha256 = fit.sha256();
  material.source.description = fit.description();
  return material;
}

}  // namespace gonio::materials
