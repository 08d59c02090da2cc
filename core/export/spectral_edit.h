// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "core/brdf/rgl_brdf.h"
#include "core/support/task_control.h"

namespace gonio::exports {

/// The spectra of an RGL file whose colours were edited. At each node every wavelength is scaled by a smooth factor, a
/// sum of spectralBasis() times three numbers from 0 to 8, chosen (least squares) so that the observer of
/// core/math/spectrum.h sees the edited colour under D65: the shape of the spectrum stays, and one factor for all
/// channels scales all wavelengths alike. What such factors cannot reach is added as the spectrum of its colour. A node
/// whose colour stays keeps its spectrum bit for bit; a value never falls below 0 (or below itself where it is
/// negative), so that very dark and saturated colours may be missed.
class SpectralEdit {
 public:
  /// @param data with spectra, whose `rgb` are their colours. @param edited other colours at the same nodes. Both are
  /// kept alive by the caller.
  SpectralEdit(const RglData& data, const SliceStack<glm::vec3>& edited);

  /// [slice][wavelength][row][column].
  std::vector<float> spectra() const;
  /// The nodes at one wavelength, nm: linear between those of the file, constant beyond them.
  SliceStack<float> plane(double nanometres) const;

 private:
  /// A wavelength is scaled by dot(basis, scale), then dot(basis, rest) is added.
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

/// A spectral file at one wavelength, in three equal channels, with the incident direction of `file`. Its own sampling
/// follows the values at that wavelength. Some ms for an isotropic file, as long as editedColours() with edits.
/// @param file with spectra
/// @param edited the same material under edits with the viewer in the slot of the incident direction; null: as measured
std::shared_ptr<const RglBrdf> atWavelength(const RglBrdf& file, const Brdf* edited, double nanometres,
                                            const TaskControl& control = {});

}  // namespace gonio::exports
