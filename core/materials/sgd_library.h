// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"
#include "core/models/model.h"

/// The published SGD fits of the 100 MERL materials in the bundled library (Bagher et al. 2012;
/// resources/ATTRIBUTIONS.md).
namespace gonio::materials {

/// The published table of parameters, CSV with a header line, compiled into the program.
std::string_view sgdTableCsv();

/// MaterialSource::format of a fit.
inline constexpr std::string_view sgdFormat = "SGD fit";

struct SgdFit {
  std::string name;                    ///< e.g. "chrome"
  models::ParameterValues parameters;  ///< parameters of the model "sgd"

  std::string description() const;  ///< "SGD fit of MERL chrome, Bagher et al. 2012"
  std::string sha256() const;       ///< of the parameters as JSON
};

/// Parses the table. @throws Error that names the line and the column.
std::vector<SgdFit> parseSgdTable(std::string_view csv);

/// The bundled fits, parsed once.
const std::vector<SgdFit>& sgdFits();

/// A fit as a material.
Material sgdMaterial(const SgdFit& fit);

}  // namespace gonio::materials
