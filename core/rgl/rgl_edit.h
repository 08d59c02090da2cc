// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio::rgl {

struct EditedRgl {
  SliceStack<glm::vec3> rgb;  ///< the field `rgb` after the edits
  bool changed = false;       ///< whether any value of it differs from the file's
};

/// The field `rgb` of an RGL file after edits: the file's values plus the difference edited - file at its own nodes.
/// Values that the edits do not change remain bitwise equal, also negative ones. Nodes with the light below the
/// horizon, which loaders also use for interpolation, are changed by the same difference as the previous node in the
/// row.
/// @param file read with IncidentDirection::viewer.
/// @param edited the material after edits, or another material that is sampled at these nodes. @throws Cancelled.
EditedRgl editedColours(const RglBrdf& file, const Brdf& edited, const TaskControl& control = {});

/// The field `luminance` of an RGL file for a field `rgb`: the luminance, in each slice at least 1/1000 of the slice's
/// maximum, so that every direction can be sampled. A slice of zeros becomes 1: loaders divide by the integral of a
/// slice and would get NaN.
SliceStack<float> samplingLuminance(const SliceStack<glm::vec3>& rgb);

/// Spectra of an RGL file with edited colours. At each node the spectrum is multiplied by a smooth function of the
/// wavelength: spectralBasis() times three numbers from 0 to 8, fitted by least squares so that its colour under D65,
/// for the observer of core/math/colour.h, is the edited colour. This preserves the shape of the spectrum; equal
/// factors in all channels scale all wavelengths equally. A remaining difference of colour is added as its spectrum in
/// spectralBasis(). Spectra of nodes with unchanged colour are bitwise unchanged. No value becomes negative, and values
/// that are negative in the file are not lowered, so very dark and saturated colours may not be reached.
class SpectralEdit {
 public:
  /// @param data with spectra, where `rgb` contains their colours. @param edited other colours at the same nodes.
  /// `data` must outlive this object.
  SpectralEdit(const RglData& data, const SliceStack<glm::vec3>& edited);

  /// [slice][wavelength][row][column].
  std::vector<float> spectra() const;
  /// All nodes at one wavelength, nm: linear between the wavelengths of the file, constant beyond them.
  SliceStack<float> plane(double nanometres) const;

 private:
  /// A value is multiplied by dot(basis, scale), then dot(basis, rest) is added.
  struct Change {
    Rgb scale{1}, rest{0};
  };
  float changed(std::size_t wavelength, float value, const Change& change) const;
  /// The change of each node, [slice][row][column].
  std::vector<Change> changes(const SliceStack<glm::vec3>& edited) const;

  const RglData& data_;
  std::vector<Rgb> observer_, basis_;  ///< of each wavelength
  std::vector<Change> changes_;
};

/// A spectral file at one wavelength, in three equal channels, with the incident direction of `file`; importance
/// sampling follows the values at that wavelength. Takes a few ms for an isotropic file; with edits as long as
/// editedColours().
/// @param file with spectra.
/// @param edited the material with edits, in IncidentDirection::viewer; null: as measured.
/// @param nanometres wavelength. @throws Cancelled.
std::shared_ptr<const RglBrdf> atWavelength(const RglBrdf& file, const Brdf* edited, double nanometres,
                                            const TaskControl& control = {});

}  // namespace gonio::rgl
