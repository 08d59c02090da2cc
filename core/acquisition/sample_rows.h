// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/dictionary/principal_components.h"

/// Linear equations for the coefficients of a basis, one per sample.
namespace gonio::acquisition {

/// Readings of one direction, or of neighbouring cells whose rows differ by at most 1 %, say the same about the
/// material. They count as one sample, their mean: otherwise, each would predict the others, and the errors and the
/// uncertainty that are estimated from the samples would be far too small.
struct SampleRows {
  std::vector<std::size_t> positions;  ///< of the samples' cells in basis.mapping.cells, the first of each mean
  std::size_t readings = 0;            ///< number of readings, at least that of the samples
  Eigen::MatrixXd rows;                ///< of D = U Sigma: samples x components
  Eigen::MatrixX3d values;             ///< mapped values minus the mean: samples x channels
  /// Variance of a sample's mapped values around the values that the components can represent, mean of the channels:
  /// the part that the components leave out, plus known noise.
  Eigen::VectorXd variances;
  Eigen::VectorXd knownNoise;  ///< the part of `variances` that is known noise; 0 if no noise is known
};

/// nearestNode() of a sample. @throws Error that names the sample.
std::uint32_t nodeOf(const HalfDifferenceGrid& grid, const PlannedSample& sample);

/// @throws Error if there are no samples, their number differs from that of the values, or a value or standard
/// deviation is negative or not finite (the message names the sample).
void checkMeasured(const SamplingPlan& plan, const MeasuredValues& values);

/// @param components at most basis.count(). @throws Error as reconstruct().
SampleRows sampleRows(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                      const MeasuredValues& values, int components);

}  // namespace gonio::acquisition
