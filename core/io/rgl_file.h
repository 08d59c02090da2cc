// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/brdf/rgl_brdf.h"
#include "core/io/byte_source.h"

namespace gonio::io {

struct RglFile {
  std::shared_ptr<const RglBrdf> brdf;  ///< with the viewer in the slot of the incident direction
  std::string description;
  std::vector<int> grid;            ///< sizes of the field `rgb`
  std::uint64_t negativeCount = 0;  ///< negative values in `rgb`
};

/// Reads an `_rgb` file of the database, isotropic or anisotropic. A luminance that is missing, 0 or not finite serves
/// sampling alone and is done without.
/// @throws FormatMismatch; Error naming the first value that is not finite.
RglFile readRgl(const ByteSource& source);

}  // namespace gonio::io
