// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/acquisition/measured_values.h"
#include "core/dictionary/principal_components.h"

/// What measurements say of the coefficients of a basis: one equation a sample.
namespace gonio::acquisition {

struct SampleRows {
  std::vector<std::size_t> positions;  ///< of the samples' cells in basis.mapping.cells
  Eigen::MatrixXd rows;                ///< of D = U Sigma: samples x components
  Eigen::MatrixX3d values;             ///< mapped values less the mean: samples x channels
  /// Of the mapped values about what the components give, mean of the channels: what they leave out, and the noise
  /// where it is known.
  Eigen::VectorXd variances;
  Eigen::VectorXd knownNoise;  ///< the part of `variances` that is known noise; 0 where none is known
};

/// nearestNode() of a sample. @throws Error naming it.
std::uint32_t nodeOf(const HalfDifferenceGrid& grid, const PlannedSample& sample);

/// @throws Error when there are no samples, numbers do not fit, or a value or a standard deviation is negative or not
/// finite, naming the sample.
void checkMeasured(const SamplingPlan& plan, const MeasuredValues& values);

/// @param components at most basis.count(). @throws Error as reconstruct().
SampleRows sampleRows(const dictionary::PrincipalComponents& basis, const SamplingPlan& plan,
                      const MeasuredValues& values, int components);

}  // namespace gonio::acquisition
