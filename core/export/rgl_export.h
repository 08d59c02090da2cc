// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/export/export_source.h"
#include "core/export/rgl_parameterisation.h"

namespace gonio::exports {

struct RglExport {
  std::vector<std::byte> rgb, spectral;  ///< contents of the files `_rgb.bsdf` and `_spec.bsdf`
  std::shared_ptr<const Brdf> brdf;      ///< the RGB file, read again
  RglSize size;
  double snr = 0;                  ///< rendered SNR of `brdf` against the material in comparisonScene(), dB
  std::size_t clippedValues = 0;   ///< number of negative channel values that were set to 0
  std::size_t negativeValues = 0;  ///< number of negative values in the RGB file: colours outside the sRGB gamut, only
                                   ///< from RGL files
  bool unchanged = false;          ///< whether the source is an RGL file with colours that the edits do not change
};

/// A material as the RGB and the spectral RGL file, for Mitsuba and pbrt. If the source is an RGL file, every field
/// that the edits do not change is copied; without edits, the result of the same kind (RGB or spectral) is the source
/// file byte for byte, provided that it has all fields, as the files of the EPFL database do. Spectra of a `_spec`
/// source are scaled as the colours change (SpectralEdit). Other materials, and all materials if a size is requested,
/// are sampled by parameterise(). @throws Error if the source's file is not an RGL file; Cancelled.
RglExport exportRgl(const ExportSource& source, const RglOptions& options = {}, const TaskControl& control = {});

}  // namespace gonio::exports
