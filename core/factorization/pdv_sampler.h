// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::factorization {

/// How the energy of a BRDF spreads over bins of |Dp|, a row for each angle of the viewer. Between two rows their
/// fractions are mixed linearly.
class DeviationRows {
 public:
  /// Whether a bin counts by the part of its ring that lies on the disk, or by the whole ring.
  enum class Ring { onDisk, whole };

  /// @param thetaNodes rows, rad; @param edges of the bins, strictly increasing from 0. At most 181 of each are used.
  DeviationRows(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& edges, Ring ring);

  /// The bin of a number in [0, 1), which serves the choice of the row too.
  std::size_t draw(double thetaR, double u) const;
  /// The probability of a bin.
  double probability(double thetaR, std::size_t bin) const;
  /// Whether all rows of a viewer are black: no bin can be sampled from them. Else the fraction of such rows, [0, 1).
  double blackShare(double thetaR) const;

  std::size_t bins() const { return edges_.size() - 1; }
  double low(std::size_t bin) const { return edges_[bin]; }
  /// Cut where the disk ends.
  double high(std::size_t bin, double sinThetaR) const;
  /// Of a deviation; bins() beyond the last.
  std::size_t binOf(double deviation) const;

 private:
  void fillRow(const Brdf& brdf, std::size_t row, Ring ring);
  const double* row(std::size_t index) const { return cumulative_.data() + index * edges_.size(); }

  std::vector<double> thetaNodes_, edges_;
  std::vector<double> cumulative_;  ///< rows of bins + 1 numbers from 0 to 1; all 0 where the row is black
};

/// Samples the direction of light for a viewer from the energy over |Dp|: a bin of |Dp| by its fraction on the disk,
/// |Dp| evenly in area within it, and the azimuth evenly in [-PHI, PHI], the part of the circle that is on the disk:
///   p_w = P(bin) cos theta_i / ((b^2 - a^2) PHI(|Dp|)),
/// which is rho~(|Dp|) cos theta_i / Z for the mean rho~ of the reflectance over the circle. No sample falls off the
/// disk, and the density integrates to 1 exactly: dissertation eq. 4.27-4.32 with the normalisation mended. A tenth of
/// the samples is cosine-weighted, so that the density is positive wherever the reflectance is; all of them where that
/// is black. Immutable; about 0.2 us per sample, and half of it a density.
class PdvSampler {
 public:
  /// @param brdf of the lobe: the first term of a model. Evaluated some 100,000 times.
  PdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& deviationNodes);

  /// Contracts of Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  double cosineShare(double thetaR) const;

  DeviationRows rows_;
};

}  // namespace gonio::factorization
