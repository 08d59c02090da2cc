// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/io/tensor_writer.h"

namespace gonio::exports {

/// The kind of colours in an RGL file. Mitsuba's RGB variants only read files with `rgb`, pbrt only those with
/// `spectra`.
enum class RglColours { rgb, spectra };

/// Linear sRGB values as the field `rgb`, or as `spectra` of spectralBasis() with its `wavelengths`.
/// @param rgb one slice per incident direction.
/// @param incident the azimuths and polar angles of the incident directions, rad.
std::vector<io::TensorField> colourFields(const SliceStack<glm::vec3>& rgb, const ParameterGrid& incident,
                                          RglColours colours);

/// `data` as the fields of an RGL file that pbrt, Mitsuba and powitacq load.
/// @param description text of the field `description`, not empty.
std::vector<io::TensorField> rglFields(const RglData& data, const std::string& description, RglColours colours);

/// The complete data of a material's tables: the densities in the warps are copied back to their fields.
RglData wholeData(const RglBrdf::Tables& tables);

}  // namespace gonio::exports
