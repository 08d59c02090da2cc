// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/io/tensor_writer.h"

namespace gonio::exports {

/// How an RGL file has its colours: Mitsuba's RGB variants take files of the first kind alone, pbrt those of the
/// second.
enum class RglColours { rgb, spectra };

/// Linear sRGB values as the field `rgb`, or as `spectra` of spectralBasis() with its `wavelengths`.
/// @param rgb a slice for each incident direction
/// @param incident its azimuths and polar angles
std::vector<io::TensorField> colourFields(const SliceStack<glm::vec3>& rgb, const ParameterGrid& incident,
                                          RglColours colours);

/// `data` as the fields of an RGL file that pbrt, Mitsuba and powitacq load.
/// @param description what the file says of itself, not empty
std::vector<io::TensorField> rglFields(const RglData& data, const std::string& description, RglColours colours);

/// What an RGL file holds, of its tables: the data with the densities that are moved into the warps.
RglData wholeData(const RglBrdf::Tables& tables);

}  // namespace gonio::exports
