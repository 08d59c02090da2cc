// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_source.h"
#include "core/export/rgl_parameterisation.h"

namespace gonio::exports {

struct RglExport {
  std::vector<std::byte> rgb, spectral;  ///< of the files `_rgb.bsdf` and `_spec.bsdf`
  std::shared_ptr<const Brdf> brdf;      ///< of the RGB file, read again
  RglSize size;
  double snr = 0;                  ///< dB in comparisonScene() of the RGB file, read again, against the material
  std::size_t clippedValues = 0;   ///< negative channels that were set to 0
  std::size_t negativeValues = 0;  ///< negative values in the RGB file: colours outside sRGB, of RGL files
  bool unchanged = false;          ///< the file has the source's own colours
};

/// A material as the two files that Mitsuba and pbrt read. An RGL file keeps every field that its edits do not change,
/// and without edits (and all fields in place, as those of the database have) all its bytes, in the one of the two
/// that it is; all else, and every material where a size is asked for, becomes what parameterise() makes of it. Spectra
/// of a `_spec` source are scaled as the colours change (SpectralEdit).
/// @throws Error where the source's file is no RGL file; Cancelled.
RglExport exportRgl(const ExportSource& source, const RglOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::exports
