// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <optional>

#include "core/brdf/brdf.h"
#include "core/brdf/grain_lobe.h"
#include "core/brdf/lobe_mixture.h"
#include "core/brdf/sampling_lobe.h"
#include "core/math/marginal_warp.h"

namespace gonio {

/// A density for importance sampling of any BRDF: its value times cos theta_i, tabulated for
/// several viewers over the unit square of half vectors (core/brdf/lobe_square.h). For an anisotropic BRDF the table is
/// the mean over several azimuths, and grain() follows the highlight. A lobe for LobeMixture; the preview's shader
/// reads the same table. Samples with a half vector that faces away from the viewer, or with a direction below the
/// horizon, fail (a few in a thousand, for grazing viewers), so that LobeMixture gets no direction below the horizon.
class TabulatedLobe {
 public:
  /// Evaluates the BRDF about 50,000 times (a few ms), an anisotropic one about 430,000 times.
  explicit TabulatedLobe(const Brdf& brdf);

  /// Fraction of cosine-weighted samples in tabulatedMixture(); they also find highlights between the nodes.
  static constexpr double cosineFraction = 0.1;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;

  static constexpr std::size_t columns = 96, rows = 21, viewerCount = 24;
  /// The tabulated density; one slice per viewer.
  const MarginalWarp& warp() const { return warp_; }
  /// The lobe along the grain, to mix with sample(); its fraction is 0 for isotropic BRDFs.
  const GrainLobe& grain() const { return grain_; }
  const RotatedLobe<VisibleNormalLobe>& alongGrain() const { return alongGrain_; }
  /// The closed-form, rotationally symmetric lobe to use instead of the table, if it gives less noise at equal time;
  /// empty otherwise.
  const std::optional<SamplingLobe>& symmetricLobe() const { return symmetricLobe_; }
  /// Approximate rendering time per sample, relative to a closed-form lobe.
  static constexpr double cost = 1.2;

 private:
  MarginalWarp warp_;
  GrainLobe grain_;
  RotatedLobe<VisibleNormalLobe> alongGrain_;
  std::optional<SamplingLobe> symmetricLobe_;
};

/// Whether two lobes sample about equally well: their densities overlap by at least nine tenths.
bool areSimilar(const TabulatedLobe& a, const TabulatedLobe& b);

/// A lobe that refers to a TabulatedLobe, which must outlive it.
struct TabulatedLobeView {
  const TabulatedLobe& lobe;

  Direction sample(const Direction& wo, const glm::dvec2& u) const { return lobe.sample(wo, u); }
  double density(const Direction& w, const Direction& wo) const { return lobe.density(w, wo); }
};

/// The lobe and its grain, mixed with a tenth of cosine-weighted directions. `lobe` must outlive the mixture.
using TabulatedMixture = LobeMixture<CosineLobe, RotatedLobe<VisibleNormalLobe>, TabulatedLobeView>;
inline TabulatedMixture tabulatedMixture(const TabulatedLobe& lobe) {
  constexpr double rest = 1 - TabulatedLobe::cosineFraction;
  const double grain = rest * lobe.grain().fraction;
  return {
      {TabulatedLobe::cosineFraction, grain, rest - grain}, CosineLobe{}, lobe.alongGrain(), TabulatedLobeView{lobe}};
}

}  // namespace gonio
