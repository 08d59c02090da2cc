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
  bool isSpectral = false;          ///< a `_spec` file: `spectra` in place of `rgb`
  std::vector<int> grid;            ///< sizes of the field `rgb` or `spectra`
  std::uint64_t negativeCount = 0;  ///< negative values in it
};

/// Reads an `_rgb` or a `_spec` file of the database, isotropic or anisotropic. Spectra are seen under D65 by the CIE
/// 1931 observer (spectrumWeights()). A luminance serves sampling alone: where it is 0 or not finite the visible
/// normals are sampled. A file without `luminance` and `vndf`, such as the bundled ones (scripts/bundle_rgl.py), has
/// them computed from its colours and from `ndf` (or `visible_ndf`, of the same layout).
/// @throws FormatMismatch; Error naming the first value that is not finite.
RglFile readRgl(const ByteSource& source);

}  // namespace gonio::io
