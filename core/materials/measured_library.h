// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/materials/material.h"

/// The measured materials of the bundled library: files of the RGL database (Dupuy and Jakob 2018, CC0), in their own
/// adaptive parameterisation, without the fields that are computed (scripts/bundle_rgl.py; resources/ATTRIBUTIONS.md).
namespace gonio::materials {

struct MeasuredMaterial {
  std::string name;                 ///< "cc_iris_purple_gem"
  std::span<const std::byte> file;  ///< its bytes, an RGL file

  /// "RGL, measured: TeckWrap vinyl wrapping film (Iris Purple Gem RD03)".
  std::string description() const;
  /// Of the file.
  std::string sha256() const;
};

/// All of them, in the order of the list.
const std::vector<MeasuredMaterial>& measuredMaterials();

/// Read from the bytes. About 12 ms.
Material measuredMaterial(const MeasuredMaterial& measured);

}  // namespace gonio::materials
