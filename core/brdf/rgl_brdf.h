// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/incident_slot.h"
#include "core/math/marginal_warp.h"

namespace gonio {

/// The reflectance of a `_spec` file over the same square as RglData::rgb, per wavelength.
struct RglSpectra {
  std::vector<float> nanometres;  ///< ascending
  std::vector<float> values;      ///< [slice][wavelength][row][column]
};

/// What an RGL file holds, as far as evaluation and sampling need it. The unit square of the microfacet normal has
/// x = sqrt(theta 2/pi), y = (phi + pi) / 2 pi.
struct RglData {
  ParameterGrid incident{{0}, {0}};  ///< azimuths and polar angles of the incident direction, rad
  SliceStack<float> ndf;             ///< distribution of microfacet normals, one slice
  SliceStack<float> sigma;           ///< projected microfacet area seen from the incident direction, one slice
  SliceStack<float> vndf;            ///< distribution of visible normals, a slice an incident direction
  SliceStack<float> luminance;       ///< of the reflectance over the square that the vndf warps to, a slice each
  SliceStack<glm::vec3> rgb;         ///< the reflectance over that square, a slice each
  bool isotropic = true;
  /// How many times the measured range of incident azimuths covers the circle: 2 for materials that are the same after
  /// half a turn, 4 for those with two planes of symmetry. The range starts at -pi.
  int azimuthReduction = 1;
  bool jacobian = true;  ///< rgb is divided by ndf / (4 sigma)
  /// Of a `_spec` file, else null: `rgb` is what the CIE 1931 observer sees of them under D65.
  std::shared_ptr<const RglSpectra> spectra;
};

/// The field `vndf` of a distribution of normals: D(m) max(0, w_i . m) du for each incident direction, of any scale
/// (Dupuy and Jakob 2018, eq. 8). Of an isotropic file, whose distribution has two rows, as many rows as columns.
SliceStack<float> visibleNormals(const SliceStack<float>& ndf, const ParameterGrid& incident, bool isotropic);

/// A material of the EPFL RGL database in its own adaptive parameterisation: Dupuy and Jakob, "An Adaptive
/// Parameterization for Efficient Material Acquisition and Rendering" (2018), section 5. What the file stores includes
/// the cosine of its outgoing direction, so that evaluation divides by it (by 0.001 at least); directions on the
/// horizon give 0. A channel may be negative: colours outside the sRGB gamut, kept as Mitsuba keeps them, since cut
/// values would add up to another colour. Not exactly reciprocal, as measured. About 0.2 us per pair.
class RglBrdf final : public Brdf {
 public:
  /// @throws Error where the vndf or the luminance is no density.
  explicit RglBrdf(RglData data, IncidentSlot slot = IncidentSlot::viewer);
  /// The same file read in another order; shares its data.
  std::shared_ptr<const RglBrdf> withIncident(IncidentSlot slot) const;
  IncidentSlot incidentSlot() const { return slot_; }
  /// The same parameterisation with other colours, without spectra. @param rgb of the size of the data's `rgb`.
  /// @param luminance what is sampled, a slice for each incident direction.
  std::shared_ptr<const RglBrdf> withColours(SliceStack<glm::vec3> rgb, SliceStack<float> luminance) const;

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override;
  bool isIsotropic() const override { return tables_->data.isotropic; }
  bool isReciprocal() const override { return slot_ == IncidentSlot::mean; }
  const RglBrdf* asRgl() const override { return this; }

  /// The file's own importance sampling (section 5.2): its luminance, then its visible normals, both seen by the
  /// viewer, beside a tenth of cosine-weighted directions. The density is that of the viewer's slot in every order.
  bool hasImportanceSampling() const override { return true; }
  double samplingCost() const override { return 1.9; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override;
  double pdf(const Direction& wi, const Direction& wo) const override;

  /// What is shared between the orders; the field vndf of the data is moved into its warp, as is the luminance.
  struct Tables {
    RglData data;
    MarginalWarp visibleNormals, luminance;
  };
  const std::shared_ptr<const Tables>& tables() const { return tables_; }

 private:
  RglBrdf(std::shared_ptr<const Tables> tables, IncidentSlot slot) : tables_(std::move(tables)), slot_(slot) {}

  std::shared_ptr<const Tables> tables_;
  IncidentSlot slot_;
};

}  // namespace gonio
