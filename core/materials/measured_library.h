// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/materials/material.h"

/// The measured materials of the bundled library: RGL (Dupuy and Jakob 2018, CC0), as sparse codes over
/// bundledDictionary() (resources/ATTRIBUTIONS.md).
namespace gonio::materials {

struct MeasuredMaterial {
  std::string name;                 ///< "cc_iris_purple_gem"
  int coefficients = 0;             ///< a channel, at most
  double renderedSnr = 0;           ///< of the code against the measured table in comparisonScene(), dB
  std::span<const std::byte> code;  ///< the file

  /// "RGL, measured; code of 700 coefficients a channel, rendered SNR 45.1 dB".
  std::string description() const;
  /// Of the file.
  std::string sha256() const;
};

/// The list as it lies beside the codes: CSV with the columns name, coefficients, rendered_snr.
std::string_view measuredFigures();

/// All of them, in the order of the list.
const std::vector<MeasuredMaterial>& measuredMaterials();

/// Decoded. Under 50 ms.
Material measuredMaterial(const MeasuredMaterial& measured);

}  // namespace gonio::materials
