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

/// A density for importance sampling any BRDF that has none of its own: its value times the cosine, tabulated
/// for some viewers over the unit square of half vectors (core/brdf/lobe_square.h) with the
/// azimuth relative to the viewer's; of an anisotropic BRDF the mean over some azimuths, beside which grain() follows
/// its highlight. A lobe for LobeMixture; the preview's shader reads the same numbers. Draws whose half vector the
/// viewer cannot see, and those below the horizon, are lost (some per mille, at grazing viewers).
class TabulatedLobe {
 public:
  /// Evaluates the BRDF about 40,000 times: some ms; an anisotropic one ten times as often.
  explicit TabulatedLobe(const Brdf& brdf);

  /// Of the samples that are cosine-weighted in tabulatedMixture(), so that what lies between the nodes is found too.
  static constexpr double cosineShare = 0.1;

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;

  static constexpr std::size_t columns = 96, rows = 21, viewerCount = 24;
  /// Slices are the viewers.
  const MarginalWarp& warp() const { return warp_; }
  /// To be mixed with sample(); its fraction is 0 for isotropic BRDFs.
  const GrainLobe& grain() const { return grain_; }
  const TurnedLobe<VisibleNormalLobe>& alongGrain() const { return alongGrain_; }
  /// What serves an isotropic BRDF with less noise at equal time, where a lobe of closed form does.
  const std::optional<SamplingLobe>& round() const { return round_; }
  /// The time of a picture's sample, about, in units of one from a lobe of closed form.
  static constexpr double cost = 1.2;

 private:
  MarginalWarp warp_;
  GrainLobe grain_;
  TurnedLobe<VisibleNormalLobe> alongGrain_;
  std::optional<SamplingLobe> round_;
};

/// Whether two lobes sample about as well as each other: their densities have nine tenths in common.
bool areSimilar(const TabulatedLobe& a, const TabulatedLobe& b);

/// Refers to a lobe that lives elsewhere.
struct TabulatedLobeView {
  const TabulatedLobe& lobe;

  Direction sample(const Direction& wo, const glm::dvec2& u) const { return lobe.sample(wo, u); }
  double density(const Direction& w, const Direction& wo) const { return lobe.density(w, wo); }
};

/// The lobe with its grain beside a tenth of cosine-weighted directions.
using TabulatedMixture = LobeMixture<CosineLobe, TurnedLobe<VisibleNormalLobe>, TabulatedLobeView>;
inline TabulatedMixture tabulatedMixture(const TabulatedLobe& lobe) {
  constexpr double rest = 1 - TabulatedLobe::cosineShare;
  const double grain = rest * lobe.grain().fraction;
  return {{TabulatedLobe::cosineShare, grain, rest - grain}, CosineLobe{}, lobe.alongGrain(), TabulatedLobeView{lobe}};
}

}  // namespace gonio
