// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <utility>

#include "core/brdf/brdf.h"
#include "core/brdf/lobe_mixture.h"

namespace gonio::models {

/// Quantities of a pair of directions that most models need, computed without cancellation.
struct SurfaceGeometry {
  Direction wi, wo;
  Direction half;       ///< unit half vector
  double cosI, cosO;    ///< cosines of the polar angles, > 0
  double cosD;          ///< cosine of the difference angle: half . wi = half . wo
  double sin2H;         ///< sin^2 theta_h = half.x^2 + half.y^2 (not 1 - cos^2: exact at the highlight)
  double oneMinusCosH;  ///< 1 - cos theta_h, by sin2H / (1 + cos theta_h)
};

/// Returns false where a BRDF is 0 by definition: wi = -wo, or a direction at or below the horizon. Since models divide
/// by cosines, directions less than `horizonTolerance` above the horizon count as on it.
bool surfaceGeometry(const DirectionPair& pair, SurfaceGeometry& geometry);

/// A Brdf of a function `Rgb evaluate(const SurfaceGeometry&)`, 1/sr, without the cosine, and a LobeMixture for
/// importance sampling.
template <typename Evaluate, typename Sampler>
class GeometryBrdf final : public Brdf {
 public:
  GeometryBrdf(Evaluate evaluatePair, Sampler sampler, bool isotropic, bool reciprocal)
      : evaluatePair_(std::move(evaluatePair)),
        sampler_(std::move(sampler)),
        isotropic_(isotropic),
        reciprocal_(reciprocal) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    SurfaceGeometry geometry;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = surfaceGeometry(pairs[i], geometry) ? evaluatePair_(geometry) : Rgb(0);
  }
  bool isIsotropic() const override { return isotropic_; }
  bool hasImportanceSampling() const override { return true; }
  bool isReciprocal() const override { return reciprocal_; }
  /// No model distinguishes a side of the plane of incidence.
  bool isMirrorSymmetric() const override { return isotropic_; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_.pdf(wi, wo); }

 private:
  Evaluate evaluatePair_;
  Sampler sampler_;
  bool isotropic_, reciprocal_;
};

template <typename Evaluate, typename Sampler = CosineSampler>
std::unique_ptr<const Brdf> makeGeometryBrdf(Evaluate evaluatePair, Sampler sampler = cosineSampler(),
                                             bool isotropic = true, bool reciprocal = true) {
  return std::make_unique<const GeometryBrdf<Evaluate, Sampler>>(std::move(evaluatePair), std::move(sampler), isotropic,
                                                                 reciprocal);
}

}  // namespace gonio::models
