// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>

#include "core/brdf/brdf.h"
#include "core/brdf/lobe_mixture.h"
#include "core/math/marginal_warp.h"

namespace gonio {

/// A density for importance sampling any BRDF that has none of its own: its value times the cosine, tabulated
/// for some viewers over the unit square of half vectors (core/brdf/lobe_square.h) with the
/// azimuth relative to the viewer's; of an anisotropic BRDF the mean over some azimuths. A lobe for LobeMixture; the
/// preview's shader reads the same numbers. Draws whose half vector the viewer cannot see are lost (some per mille, at
/// grazing viewers).
class TabulatedLobe {
 public:
  /// Evaluates the BRDF about 40,000 times: some ms.
  explicit TabulatedLobe(const Brdf& brdf);

  Direction sample(const Direction& wo, const glm::dvec2& u) const;
  double density(const Direction& w, const Direction& wo) const;

  static constexpr std::size_t columns = 96, rows = 21, viewerCount = 24;
  /// Slices are the viewers.
  const MarginalWarp& warp() const { return warp_; }

 private:
  MarginalWarp warp_;
};

/// Whether two lobes draw about as well as each other: their densities have nine tenths in common.
bool areSimilar(const TabulatedLobe& a, const TabulatedLobe& b);

/// Refers to a lobe that lives elsewhere.
struct TabulatedLobeView {
  const TabulatedLobe& lobe;

  Direction sample(const Direction& wo, const glm::dvec2& u) const { return lobe.sample(wo, u); }
  double density(const Direction& w, const Direction& wo) const { return lobe.density(w, wo); }
};

/// The lobe beside a tenth of cosine-weighted directions, so that what lies between its nodes is found too.
using TabulatedMixture = LobeMixture<CosineLobe, TabulatedLobeView>;
inline TabulatedMixture tabulatedMixture(const TabulatedLobe& lobe) {
  constexpr double cosineShare = 0.1;
  return {{cosineShare, 1 - cosineShare}, CosineLobe{}, TabulatedLobeView{lobe}};
}

}  // namespace gonio
