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
  std::shared_ptr<const RglBrdf> brdf;  ///< with IncidentDirection::viewer
  std::string description;
  bool isSpectral = false;          ///< whether it is a `_spec` file, with `spectra` instead of `rgb`
  std::vector<int> grid;            ///< sizes of the field `rgb` or `spectra`
  std::uint64_t negativeCount = 0;  ///< number of negative values in that field
};

/// Reads an `_rgb` or a `_spec` file of the database, isotropic or anisotropic. Spectra are converted to linear sRGB
/// under D65 for the CIE 1931 observer (spectrumWeights()). The field `luminance` is only used for importance sampling.
/// If `luminance` and `vndf` are missing, as in bundled files (scripts/bundle_rgl.py), they are computed from the
/// colours and from `ndf` (or `visible_ndf`, of the same layout). @throws FormatMismatch; Error that names the first
/// value that is not finite.
RglFile readRgl(const ByteSource& source);

}  // namespace gonio::io
