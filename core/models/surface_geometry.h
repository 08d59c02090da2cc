// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <utility>

#include "core/brdf/brdf.h"
#include "core/brdf/density_mixture.h"

namespace gonio::models {

/// Quantities of a pair of directions that most models need, computed without cancellation.
struct SurfaceGeometry {
  Direction wi, wo;
  Direction h;          ///< unit half vector
  double cosI, cosO;    ///< cosines of the polar angles, > 0
  double cosD;          ///< cosine of the difference angle: h . wi = h . wo
  double sin2H;         ///< sin^2 theta_h = h.x^2 + h.y^2 (not 1 - cos^2: exact at the highlight)
  double oneMinusCosH;  ///< 1 - cos theta_h, by sin2H / (1 + cos theta_h)
};

/// Whether a BRDF is not 0 by definition: false for wi = -wo, and for a direction at or below the horizon. Since models
/// divide by cosines, directions less than `horizonTolerance` above the horizon count as on it.
inline bool isAboveSurface(const DirectionPair& pair) {
  constexpr double minSquaredHalfLength = 1e-24;
  const Direction sum = pair.wi + pair.wo;
  const bool hasHalf = glm::dot(sum, sum) >= minSquaredHalfLength;
  return hasHalf & (pair.wi.z > horizonTolerance) & (pair.wo.z > horizonTolerance);
}

/// Of a pair for which isAboveSurface() is true. Without branches.
inline SurfaceGeometry surfaceGeometry(const DirectionPair& pair) {
  const Direction sum = pair.wi + pair.wo;
  const double length = std::sqrt(glm::dot(sum, sum));
  SurfaceGeometry g;
  g.wi = pair.wi;
  g.wo = pair.wo;
  g.h = sum / length;
  g.cosI = std::min(1.0, pair.wi.z);
  g.cosO = std::min(1.0, pair.wo.z);
  // |wi + wo| = 2 cos theta_d for unit vectors.
  g.cosD = std::min(1.0, length / 2);
  g.sin2H = g.h.x * g.h.x + g.h.y * g.h.y;
  g.oneMinusCosH = g.sin2H / (1 + g.h.z);
  return g;
}

/// The geometry of several pairs, an array for each quantity: the layout that vector code needs. Pairs for which
/// isAboveSurface() is false have the geometry of the normal.
class GeometryBlock {
 public:
  static constexpr std::size_t size = 32;
  using Row = double[size];

  /// @param pairs at most `size`.
  explicit GeometryBlock(std::span<const DirectionPair> pairs) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const bool isAbove = models::isAboveSurface(pairs[i]);
      const DirectionPair pair = isAbove ? pairs[i] : DirectionPair{};
      const SurfaceGeometry g = surfaceGeometry(pair);
      isAbove_[i] = isAbove ? 1 : 0;
      wiX_[i] = g.wi.x, wiY_[i] = g.wi.y, wiZ_[i] = g.wi.z;
      woX_[i] = g.wo.x, woY_[i] = g.wo.y, woZ_[i] = g.wo.z;
      halfX_[i] = g.h.x, halfY_[i] = g.h.y, halfZ_[i] = g.h.z;
      cosI_[i] = g.cosI, cosO_[i] = g.cosO, cosD_[i] = g.cosD;
      sin2H_[i] = g.sin2H, oneMinusCosH_[i] = g.oneMinusCosH;
    }
  }
  bool isAboveSurface(std::size_t i) const { return isAbove_[i] != 0; }
  SurfaceGeometry at(std::size_t i) const {
    return {.wi = {wiX_[i], wiY_[i], wiZ_[i]},
            .wo = {woX_[i], woY_[i], woZ_[i]},
            .h = {halfX_[i], halfY_[i], halfZ_[i]},
            .cosI = cosI_[i],
            .cosO = cosO_[i],
            .cosD = cosD_[i],
            .sin2H = sin2H_[i],
            .oneMinusCosH = oneMinusCosH_[i]};
  }

 private:
  Row isAbove_, wiX_, wiY_, wiZ_, woX_, woY_, woZ_, halfX_, halfY_, halfZ_, cosI_, cosO_, cosD_, sin2H_, oneMinusCosH_;
};

/// A function for GeometryBrdf in two steps: `finish` also gets the number that `prepare` returns for the pair. Two
/// loops become vector code where the compiler gives up on one long loop.
template <typename Prepare, typename Finish>
struct TwoSteps {
  Prepare prepare;
  Finish finish;
};
template <typename Prepare, typename Finish>
TwoSteps(Prepare, Finish) -> TwoSteps<Prepare, Finish>;  // clang does not deduce it before version 17

/// A Brdf of a function `Rgb evaluate(const SurfaceGeometry&)`, 1/sr, without the cosine, or of TwoSteps, and a
/// DensityMixture for importance sampling.
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
    for (std::size_t first = 0; first < pairs.size(); first += GeometryBlock::size) {
      const std::size_t count = std::min(GeometryBlock::size, pairs.size() - first);
      evaluateBlock(GeometryBlock(pairs.subspan(first, count)), values.subspan(first, count));
    }
  }
  std::shared_ptr<const ValueBound> valueBound() const override {
    if constexpr (requires { evaluatePair_.valueBound(); })
      return evaluatePair_.valueBound();
    else
      return nullptr;
  }
  bool isIsotropic() const override { return isotropic_; }
  bool hasImportanceSampling() const override { return true; }
  bool isReciprocal() const override { return reciprocal_; }
  /// No model distinguishes a side of the plane of incidence.
  bool isMirrorSymmetric() const override { return isotropic_; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_.pdf(wi, wo); }

 private:
  void evaluateBlock(const GeometryBlock& block, std::span<Rgb> values) const {
    if constexpr (requires { evaluatePair_.prepare; }) {
      GeometryBlock::Row prepared;
      for (std::size_t i = 0; i < values.size(); ++i) prepared[i] = evaluatePair_.prepare(block.at(i));
      fill(block, values, [&](std::size_t i) { return evaluatePair_.finish(block.at(i), prepared[i]); });
    } else {
      fill(block, values, [&](std::size_t i) { return evaluatePair_(block.at(i)); });
    }
  }
  /// Becomes vector code if `valueAt` has no calls and can be computed without branches.
  template <typename ValueAt>
  static void fill(const GeometryBlock& block, std::span<Rgb> values, const ValueAt& valueAt) {
    GeometryBlock::Row red, green, blue;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Rgb value = valueAt(i);
      red[i] = value.x;
      green[i] = value.y;
      blue[i] = value.z;
    }
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = block.isAboveSurface(i) ? Rgb(red[i], green[i], blue[i]) : Rgb(0);
  }

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
