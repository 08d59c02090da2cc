// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "core/factorization/nonparametric.h"
#include "core/io/byte_source.h"

/// The published table of non-parametric factors of 100 MERL materials (Bagher et al. 2016), little-endian: float32
/// [rows][512 columns][RGB], a material a row. Column 0 is the diffuse part, 1 the strength of the lobe, 2 to 91 D, 93
/// to 182 G, 183 to 272 F; the rest is not used. A table beside it, CSV with the header "row,material", names the rows.
///
/// There, D and F are read by the floor of their node; makeNonparametricBrdf() draws lines between the nodes, which is
/// the same at the nodes. The last entry of D and of F is a mark (1e-6) in place of a value: it becomes the one before.
namespace gonio::factorization {

struct NpfTable {
  std::map<std::string, NonparametricFactors, std::less<>> materials;

  /// Null when there is none of this name.
  const NonparametricFactors* find(std::string_view material) const;
};

/// Reads a table and, beside it, npf_row_order.csv.
/// @throws Error naming the file: what was found, what was expected.
NpfTable readNpf(const std::filesystem::path& path);
/// The same of bytes and text; an error names no file. Nothing is allocated that the source's size does not bear out.
NpfTable readNpf(const io::ByteSource& source, std::string_view rowNames);

}  // namespace gonio::factorization
