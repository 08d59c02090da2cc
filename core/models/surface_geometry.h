// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <memory>
#include <utility>

#include "core/brdf/brdf.h"

namespace gonio::models {

/// What most models ask of a pair of directions, computed once and without cancellation.
struct SurfaceGeometry {
  Direction wi, wo;
  Direction half;       ///< unit half vector
  double cosI, cosO;    ///< cosines of the polar angles, > 0
  double cosD;          ///< cosine of the difference angle: half . wi = half . wo
  double sin2H;         ///< sin^2 theta_h = half.x^2 + half.y^2 (not 1 - cos^2: exact at the highlight)
  double oneMinusCosH;  ///< 1 - cos theta_h, by sin2H / (1 + cos theta_h)
};

/// False where a BRDF is 0 by definition: wi = -wo, or a direction at or below the horizon. Models divide by cosines,
/// so down to `horizonTolerance` above it counts as at the horizon too: cosines given to models are at least that
/// large.
bool surfaceGeometry(const DirectionPair& pair, SurfaceGeometry& geometry);

/// Makes a Brdf of a function `Rgb evaluate(const SurfaceGeometry&)`.
template <typename Evaluate>
class GeometryBrdf final : public Brdf {
 public:
  explicit GeometryBrdf(Evaluate evaluatePair, bool isotropic = true)
      : evaluatePair_(std::move(evaluatePair)), isotropic_(isotropic) {}

  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair> pairs, std::span<Rgb> values) const override {
    SurfaceGeometry geometry;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      values[i] = surfaceGeometry(pairs[i], geometry) ? evaluatePair_(geometry) : Rgb(0);
  }
  bool isIsotropic() const override { return isotropic_; }

 private:
  Evaluate evaluatePair_;
  bool isotropic_;
};

template <typename Evaluate>
std::unique_ptr<const Brdf> makeGeometryBrdf(Evaluate evaluatePair, bool isotropic = true) {
  return std::make_unique<const GeometryBrdf<Evaluate>>(std::move(evaluatePair), isotropic);
}

}  // namespace gonio::models
