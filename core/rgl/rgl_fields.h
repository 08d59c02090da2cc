// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/io/tensor_writer.h"
#include "core/rgl/rgl_edit.h"

namespace gonio::rgl {

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
/// @throws FormatMismatch if `file` is not an RGL file.
std::vector<std::byte> withColours(std::span<const std::byte> file, const RglBrdf::Tables& tables,
                                   const EditedRgl& edited, RglColours colours, const std::string& description);

}  // namespace gonio::rgl
