// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/math/marginal_warp.h"

namespace gonio {

/// The spectral values of a `_spec` file, over the same square as RglData::rgb.
struct RglSpectra {
  std::vector<float> nanometres;  ///< ascending
  std::vector<float> values;      ///< [slice][wavelength][row][column]
};

/// The fields of an RGL file that evaluation and sampling need. The unit square of microfacet normals is that of
/// core/brdf/normal_square.h; a slice is one incident direction.
struct RglData {
  ParameterGrid incident{{0}, {0}};  ///< azimuths and polar angles of the incident direction, rad
  SliceStack<float> ndf;             ///< distribution of microfacet normals, one slice
  SliceStack<float> sigma;           ///< projected microfacet area seen from the incident direction, one slice
  SliceStack<float> vndf;            ///< distribution of visible normals, one slice per incident direction
  SliceStack<float> luminance;       ///< luminance of the values over the square that the vndf warps to, one slice per
                                     ///< incident direction
  SliceStack<glm::vec3> rgb;         ///< the values over that square, one slice per incident direction
  bool isotropic = true;
  /// Number of copies of the measured range of incident azimuths that cover the circle: 2 for materials that are
  /// symmetric under a rotation by pi, 4 for those with two planes of symmetry. The range starts at -pi.
  int azimuthReduction = 1;
  bool jacobian = true;  ///< the stored rgb were divided by ndf / (4 sigma); evaluation multiplies by it
  /// The spectra of a `_spec` file, else null. `rgb` is the colour of these spectra under D65 for the CIE 1931
  /// observer.
  std::shared_ptr<const RglSpectra> spectra;
};

/// The field `vndf` of a distribution of normals: D(m) max(0, w_i . m) times the solid angle of normals per area of the
/// square, for each incident direction, not normalised (Dupuy and Jakob 2018, eq. 8). For an isotropic file, where
/// `ndf` has two rows, the result has as many rows as columns.
SliceStack<float> visibleNormals(const SliceStack<float>& ndf, const ParameterGrid& incident, bool isotropic);

/// A material of the EPFL RGL database in its own adaptive parameterisation: Dupuy and Jakob, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering" (2018), section 5. The stored values include the
/// cosine of the file's outgoing direction; evaluation divides by it (by at least 0.001). Directions on the horizon
/// give 0. A channel may be negative for colours outside the sRGB gamut, as in Mitsuba: clipping would change the
/// colour of integrals. Not exactly reciprocal, as measured. About 0.1 us per pair in a batch.
class RglBrdf final : public Brdf {
 public:
  /// @throws Error if the vndf is not a density: negative values, or a slice of zeros. Invalid values of the luminance
  /// count as 0; in a slice of zeros it is uniform.
  explicit RglBrdf(RglData data, IncidentDirection incident = IncidentDirection::viewer);
  /// The same file read with another setting of IncidentDirection; shares the data.
  std::shared_ptr<const RglBrdf> withIncident(IncidentDirection incident) const;
  std::optional<IncidentDirection> incidentDirection() const override { return incident_; }
  std::shared_ptr<const Brdf> readWith(IncidentDirection incident) const override { return withIncident(incident); }
  /// The same parameterisation with other values and without spectra. @param rgb of the size of the data's `rgb`.
  /// @param luminance for sampling, one slice per incident direction.
  std::shared_ptr<const RglBrdf> withColours(SliceStack<glm::vec3> rgb, SliceStack<float> luminance) const;

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isIsotropic() const override { return tables_->data.isotropic; }
  bool isReciprocal() const override { return incident_ == IncidentDirection::mean; }
  std::shared_ptr<const ValueBound> valueBound() const override;
  bool isSpectral() const override { return tables_->data.spectra != nullptr; }

  /// The file's own importance sampling (section 5.2): luminance, then visible normals, with the viewer as incident
  /// direction, mixed with a tenth of cosine-weighted directions. The density does not depend on the setting
  /// incidentDirection().
  bool hasImportanceSampling() const override { return true; }
  double samplingCost() const override { return 1.9; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override;
  double pdf(const Direction& wi, const Direction& wo) const override;

  /// Data that the BRDFs of all three settings of IncidentDirection share. The fields `vndf` and `luminance` are moved
  /// out of `data` into the warps.
  struct Tables {
    RglData data;
    MarginalWarp visibleNormals, luminance;
  };
  const std::shared_ptr<const Tables>& tables() const { return tables_; }

 private:
  RglBrdf(std::shared_ptr<const Tables> tables, IncidentDirection incident)
      : tables_(std::move(tables)), incident_(incident) {}

  std::shared_ptr<const Tables> tables_;
  IncidentDirection incident_;
};

}  // namespace gonio
