// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/io/tensor_file.h"
#include "core/rgl/rgl_edit.h"

/// Files of the RGL database (Dupuy and Jakob 2018), `.bsdf`: tensor files (core/io/tensor_file.h).
namespace gonio::rgl {

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
/// colours and from `ndf` (or `visible_ndf`, of the same layout). @throws io::FormatMismatch; Error that names the
/// first value that is not finite.
RglFile readRgl(const io::ByteSource& source);

/// The kind of colours in an RGL file. Mitsuba's RGB variants only read files with `rgb`, pbrt only those with
/// `spectra`.
enum class RglColours { rgb, spectra };

/// An RGL file that pbrt, Mitsuba and powitacq load. The field `rgb` is that of the data; `spectra` are the same
/// colours by colourSpectrum(). @param description text of the field `description`, not empty.
std::vector<std::byte> encodeRglData(const RglData& data, const std::string& description, RglColours colours);

/// The complete data of a material's tables: the densities in the warps are copied back to their fields.
RglData wholeData(const RglBrdf::Tables& tables);

/// An RGL file with other colours. Other fields are copied (16-bit numbers become 32-bit ones, which pbrt reads), and
/// fields that a bundled file omits are added. Spectra change as SpectralEdit states. Returns the file itself if it has
/// this kind of colours and all fields, and no value has changed.
/// @param file the bytes from which `tables` were read. @param description is appended to that of the file.
/// @throws io::FormatMismatch if `file` is not an RGL file.
std::vector<std::byte> withColours(std::span<const std::byte> file, const RglBrdf::Tables& tables,
                                   const EditedRgl& edited, RglColours colours, const std::string& description);

}  // namespace gonio::rgl
