// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/factorization/nonparametric.h"
#include "core/io/byte_source.h"
#include "core/materials/material.h"

/// The published table of non-parametric factors of 100 MERL materials (Bagher, Snyder and Nowrouzezahrai 2016, "A
/// Non-Parametric Factor Microfacet Model for Isotropic BRDFs"), little-endian: float32 [rows][512 columns][RGB], one
/// row per material. Column 0 is the diffuse part, 1 the strength of the lobe, 2 to 91 D, 93 to 182 G, 183 to 272 F;
/// the others are not used. The names of the rows are in a second file beside it, npf_row_order.csv, with the columns
/// row and material.
///
/// The authors read D and F at the node below; makeNonparametricBrdf() interpolates, which is equal at the nodes. The
/// last entries of D and F are not values (1e-6); the entries before them are used.
namespace gonio::materials {

/// The materials of a table by name.
struct NpfTable {
  std::string sha256;  ///< of the table and of the names of its rows
  std::map<std::string, factorization::NonparametricFactors, std::less<>> materials;

  /// Null if there is no material of this name.
  const factorization::NonparametricFactors* find(std::string_view material) const;
};

/// Reads a table and the names of its rows. @throws Error that names the file, what was found and what was expected.
NpfTable readNpf(const std::filesystem::path& path);
/// The same for bytes and text; errors name no file. Memory is allocated only for rows that the source contains.
NpfTable readNpf(const io::ByteSource& source, std::string_view rowNames);

/// Whether a path names a row of a table: "FILE#ROW", where FILE exists.
bool isNpfRow(const std::filesystem::path& path);
/// The material "FILE#ROW"; ROW is a name of npf_row_order.csv, or a number from 0, for which no names are needed.
/// @throws Error that names the file; for an unknown name it states the number of names, for a row without material its
/// number.
Material readNpfRow(const std::filesystem::path& path);

}  // namespace gonio::materials
