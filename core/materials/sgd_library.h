// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"
#include "core/models/model.h"

/// The bundled library: the published SGD fits of the 100 MERL materials (Bagher et al. 2012;
/// resources/ATTRIBUTIONS.md).
namespace gonio::materials {

/// The table as it was published, CSV with a header line, built into the program.
std::string_view sgdFigures();

/// MaterialSource::format of a fit.
inline constexpr std::string_view sgdFormat = "SGD fit";

struct SgdFit {
  std::string name;                    ///< "chrome"
  models::ParameterValues parameters;  ///< of the model "sgd"

  std::string description() const;  ///< "SGD fit of MERL chrome, Bagher et al. 2012"
  std::string sha256() const;       ///< of the parameters as JSON
};

/// Parses a table with a header that names the columns.
/// @throws Error naming the line and the column.
std::vector<SgdFit> parseSgdFigures(std::string_view csv);

/// The bundled fits, parsed once.
const std::vector<SgdFit>& sgdFits();

/// A fit as a material.
Material sgdMaterial(const SgdFit& fit);

}  // namespace gonio::materials
