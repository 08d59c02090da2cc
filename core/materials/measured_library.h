// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/materials/material.h"

/// The measured materials of the bundled library: files of the RGL database (Dupuy and Jakob 2018, CC0), in their own
/// adaptive parameterisation, without the fields that can be computed (scripts/bundle_rgl.py;
/// resources/ATTRIBUTIONS.md).
namespace gonio::materials {

struct MeasuredMaterial {
  std::string name;                 ///< e.g. "cc_iris_purple_gem"
  std::span<const std::byte> file;  ///< an RGL file

  /// For display, e.g. "RGL, measured: TeckWrap vinyl wrapping film (Iris Purple Gem RD03)".
  std::string description() const;
  /// SHA-256 of the file.
  std::string sha256() const;
};

/// All measured materials, in the order of libraryRows().
const std::vector<MeasuredMaterial>& measuredMaterials();

/// Reads the material. About 12 ms.
Material measuredMaterial(const MeasuredMaterial& measured);

}  // namespace gonio::materials
