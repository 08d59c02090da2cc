// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <optional>

#include "core/brdf/brdf.h"
#include "core/brdf/density_mixture.h"
#include "core/math/marginal_warp.h"
#include "core/sampling/fitted_densities.h"

namespace gonio {

/// A density for importance sampling of any BRDF: its value times cos theta_i, tabulated for several viewers over the
/// unit square of half vectors. Peaks narrower than the spacing of the nodes, which the bounds of the values reveal
/// (narrowPeaks()), are added with their energy. Viewers for whom the BRDF is 0 get about cosine-weighted directions.
/// For an anisotropic BRDF the table is the mean over several azimuths, and grain()
/// follows the highlight. DensityMixture takes it; the preview's shader reads the same table. Samples with a half
/// vector that faces away from the viewer, or with a direction below the horizon, fail (a few in a thousand, for
/// grazing viewers), so that DensityMixture gets no direction below the horizon.
class TabulatedDensity {
 public:
  /// Evaluates the BRDF about 50,000 times, an anisotropic one about 430,000 times, and 100,000 times more if it has
  /// narrow peaks. About 20 ms for a table, plus the time of Brdf::valueBound() for other forms.
  explicit TabulatedDensity(const Brdf& brdf);

  /// Fraction of cosine-weighted samples in tabulatedMixture(); they also find highlights between the nodes.
  static constexpr double cosineFraction = 0.1;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;

  static constexpr std::size_t columns = 96, rows = 21, viewerCount = 24;
  /// The tabulated density; one slice per viewer.
  const MarginalWarp& warp() const { return warp_; }
  /// The density along the grain, to mix with sample(); its fraction is 0 for isotropic BRDFs.
  const GrainDensity& grain() const { return grain_; }
  const RotatedDensity<VisibleNormalDensity>& alongGrain() const { return alongGrain_; }
  /// The closed-form, rotationally symmetric density to use instead of the table, if it gives less noise at equal time
  /// and finds all narrow peaks; cosine-weighted directions for a black BRDF. Empty otherwise.
  const std::optional<SamplingDensity>& symmetricDensity() const { return symmetricDensity_; }
  /// Approximate rendering time per sample, relative to a closed-form density.
  static constexpr double cost = 1.2;

 private:
  bool isBlack_ = false;
  MarginalWarp warp_;
  GrainDensity grain_;
  RotatedDensity<VisibleNormalDensity> alongGrain_;
  std::optional<SamplingDensity> symmetricDensity_;
};

/// Whether two densities sample about equally well: they overlap by at least nine tenths.
bool areSimilar(const TabulatedDensity& a, const TabulatedDensity& b);

/// A density that refers to a TabulatedDensity, which must outlive it.
struct TabulatedDensityView {
  const TabulatedDensity& table;

  Direction sample(const Direction& wo, const glm::dvec2& u) const { return table.sample(wo, u); }
  double density(const Direction& w, const Direction& wo) const { return table.density(w, wo); }
};

/// The table and its grain, mixed with a tenth of cosine-weighted directions. `table` must outlive the mixture.
using TabulatedMixture = DensityMixture<CosineDensity, RotatedDensity<VisibleNormalDensity>, TabulatedDensityView>;
inline TabulatedMixture tabulatedMixture(const TabulatedDensity& table) {
  constexpr double rest = 1 - TabulatedDensity::cosineFraction;
  const double grain = rest * table.grain().fraction;
  return {{TabulatedDensity::cosineFraction, grain, rest - grain},
          CosineDensity{},
          table.alongGrain(),
          TabulatedDensityView{table}};
}

}  // namespace gonio
