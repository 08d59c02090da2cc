// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The list of bundled materials, resources/library/materials.csv, which is compiled into the program.
namespace gonio::materials {

/// Sources of the materials in resources/library: the prefixes of their ids.
inline constexpr std::string_view rglSource = "rgl", merlCopySource = "merl-copy", rglCopySource = "rgl-copy",
                                  dtuCopySource = "dtu-copy", sgdSource = "sgd";

struct LibraryRow {
  std::string source, name;
  std::string kind;                   ///< "metal", "paint", ...
  std::optional<double> renderedSnr;  ///< against the measured file in comparisonScene(), dB; empty if unknown
};

/// CSV with the columns source, name, kind, rendered_snr (which may be empty).
std::string_view libraryListText();

/// All rows, parsed once. The other bundled data (resources/library) contain the materials of each source in this
/// order.
const std::vector<LibraryRow>& libraryRows();

/// LibraryRow::kind of a material; empty if it is not listed.
std::string libraryKind(std::string_view source, std::string_view name);

}  // namespace gonio::materials
