// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/io/material.h"
#include "core/models/model.h"

/// The bundled library: the published SGD fits of the 100 MERL materials (Bagher et al. 2012;
/// resources/ATTRIBUTIONS.md).
namespace gonio::io {

/// The table as it was published, CSV with a header line, built into the program.
std::string_view sgdFigures();

struct SgdFit {
  std::string name;                    ///< "chrome"
  models::ParameterValues parameters;  ///< of the model "sgd"
};

/// Parses a table with a header that names the columns.
/// @throws Error naming the line and the column.
std::vector<SgdFit> parseSgdFigures(std::string_view csv);

/// The bundled fits, parsed once.
const std::vector<SgdFit>& sgdFits();

/// The material of a path "library:sgd/NAME", whose hash is that of its parameters as JSON, or "library:rgl/NAME".
/// @throws Error when there is none of this name.
Material readLibraryMaterial(const std::string& path);

}  // namespace gonio::io
