// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <vector>

#include "core/brdf/brdf.h"

namespace gonio::factorization {

/// Distribution of a BRDF over bins of |Dp|, one row per angle of the viewer; interpolated linearly between rows. The
/// energy of a bin is here the integral of the BRDF value over the area of the bin (see Ring), not of ln(1 + rho).
class DeviationRows {
 public:
  /// Which part of a bin's ring contributes to its energy: only the part on the unit disk, or the whole ring.
  enum class Ring { onDisk, whole };

  /// @param thetaNodes viewer's polar angles of the rows, rad. @param edges of the bins, strictly increasing from 0. At
  /// most 181 of each are used.
  DeviationRows(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& edges, Ring ring);

  /// Samples a bin. @param u in [0, 1); selects the row and the bin.
  std::size_t sampleBin(double thetaR, double u) const;
  /// The probability of a bin.
  double probability(double thetaR, std::size_t bin) const;
  /// Total weight of rows without energy (black) in the interpolation for a viewer; 1 if no bin can be sampled.
  double blackFraction(double thetaR) const;

  std::size_t bins() const { return edges_.size() - 1; }
  double low(std::size_t bin) const { return edges_[bin]; }
  /// Upper end of a bin, limited to the disk.
  double high(std::size_t bin, double sinThetaR) const;
  /// The bin of a deviation; bins() beyond the last.
  std::size_t binOf(double deviation) const;

 private:
  void fillRow(const Brdf& brdf, std::size_t row, Ring ring);
  const double* row(std::size_t index) const { return cumulative_.data() + index * edges_.size(); }

  std::vector<double> thetaNodes_, edges_;
  std::vector<double> cumulative_;  ///< rows of bins + 1 numbers from 0 to 1; all 0 in a black row
};

/// Samples the direction of light for a viewer by the energy over |Dp|: a bin of |Dp| by its energy on the disk, |Dp|
/// uniformly in area within the bin, and the azimuth uniformly in [-PHI, PHI], the part of the circle on the disk. The
/// density is
///   p_w = P(bin) cos theta_i / ((b^2 - a^2) PHI(|Dp|)),
/// for a bin [a, b], which is rho~(|Dp|) cos theta_i / Z with rho~ the mean of the BRDF over the circle. No sample is
/// outside the disk, and the density integrates to exactly 1: Tongbuasirilai 2023, "Data-Driven Approaches for Sparse
/// Reflectance Modeling and Acquisition", eq. 4.27-4.32 with corrected normalisation. A tenth of the samples is
/// cosine-weighted, so that the density is positive wherever the BRDF is; all of them for viewers where the lobe is
/// black. Immutable. About 0.2 us per sample and 0.1 us per density.
class PdvSampler {
 public:
  /// @param brdf of the lobe, i.e. the first term of a model; evaluated about 100,000 times.
  PdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes, const std::vector<double>& deviationNodes);

  /// As Brdf::sample() and pdf().
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  double cosineFraction(double thetaR) const;

  DeviationRows rows_;
};

/// The scheme of PdvSampler as it is printed (Tongbuasirilai 2023, eq. 4.27-4.32): the azimuth uniformly over the whole
/// circle. Samples off the disk are lost (their density is 0), so that the density integrates to less than 1, to 0.4 at
/// grazing angles, and it has no cosine-weighted part.
class PublishedPdvSampler {
 public:
  /// As PdvSampler.
  PublishedPdvSampler(const Brdf& brdf, const std::vector<double>& thetaNodes,
                      const std::vector<double>& deviationNodes);

  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const;
  double pdf(const Direction& wi, const Direction& wo) const;

 private:
  DeviationRows rows_;
};

}  // namespace gonio::factorization
