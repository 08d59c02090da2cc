// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/materials/encode.h"

/// The encoders of materialFormats().
namespace gonio::materials {

/// A MERL file: of a table that folds phi_d, or does not, that table, edited cell by cell; of other materials, a table
/// of 90 x 90 x 180 or 90 x 90 x 360 angles.
Encoded encodeMerlMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control);
Encoded encodeMerlCircleMaterial(const EditedMaterial& material, const EncodeOptions& options,
                                 const TaskControl& control);
/// The spectral file of encodeRgl() if the material is a spectral RGL file whose spectra it keeps, else the RGB file.
Encoded encodeRglMaterial(const EditedMaterial& material, const EncodeOptions& options, const TaskControl& control);
/// A UTIA `.bin` file. Of a UTIA file, the change of the edits is added to the values at its nodes.
Encoded encodeUtiaMaterial(const EditedMaterial& material, const EncodeOptions&, const TaskControl& control);

}  // namespace gonio::materials
