// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The list of the bundled materials, resources/library/materials.csv, which is built into the program.
namespace gonio::materials {

/// What lies in resources/library, by source: the prefix of the ids.
inline constexpr std::string_view rglSource = "rgl", merlCopySource = "merl-copy", rglCopySource = "rgl-copy",
                                  dtuCopySource = "dtu-copy", sgdSource = "sgd";

struct LibraryRow {
  std::string source, name;
  std::string kind;                   ///< "metal", "paint", ...
  std::optional<double> renderedSnr;  ///< dB, against the measured file in comparisonScene(); known of some
};

/// CSV with the columns source, name, kind, rendered_snr (which may be empty).
std::string_view libraryListText();

/// All rows, parsed once. Files of one source lie in their order.
const std::vector<LibraryRow>& libraryRows();

/// "" of a material that is not listed.
std::string libraryKind(std::string_view source, std::string_view name);

}  // namespace gonio::materials
