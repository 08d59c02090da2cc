// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <array>
#include <memory>

#include "core/factorization/half_difference_samples.h"
#include "core/factorization/tensor.h"

namespace gonio::baselines {

/// A BRDF as a tensor of y = ln(1 + rho) over theta_h, theta_d, phi_d and the three channels, decomposed without
/// weights. A cell with a direction below the horizon takes the value of the nearest theta_h where both are above,
/// because a dense tensor needs a value in every cell. Reciprocal.
///
/// Factors are linear between their nodes. A sum of products of such factors equals the multilinear interpolation of
/// its values at the nodes, so the model is evaluated from the composed tensor; `bytes` counts the factors.
struct HalfDifferenceTensor {
  factorization::HalfDifferenceAxes axes;
  factorization::Tensor values;  ///< y, composed from the factors; sizes thetaH, thetaD, phiD, 3; thetaH fastest
  double highest = 0;            ///< largest y of the measurement; sums are clamped to [0, highest]
  double residual = 0;           ///< relative Frobenius norm of the residual; 0 for a black material
  std::size_t bytes = 0;         ///< of the factors and `highest` in single precision, without the nodes of the axes
};

/// y at all nodes, invalid cells filled; residual 0.
HalfDifferenceTensor sampleHalfDifferenceTensor(const factorization::HalfDifferenceSamples& samples);

/// Maximum number of terms of a CP decomposition.
inline constexpr int maxCpTerms = 64;
/// The largest number of terms of a CP decomposition that fits in the budget, from 1 to maxCpTerms.
int cpTerms(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget);
/// The sum of `terms` products of four curves, y = sum_r a_r(theta_h) b_r(theta_d) c_r(phi_d) d_r(channel), by
/// alternating least squares (at most 100 sweeps). Carroll and Chang 1970, "Analysis of Individual Differences in
/// Multidimensional Scaling via an N-way Generalization of 'Eckart-Young' Decomposition"; Kolda and Bader 2009, "Tensor
/// Decompositions and Applications", section 3. Takes seconds. @throws Cancelled.
HalfDifferenceTensor decomposeCp(const HalfDifferenceTensor& tensor, int terms, const TaskControl& control = {});

/// The largest ranks of theta_h, theta_d and phi_d, in proportion to the sizes of the modes, that fit in the budget,
/// each at least 1. The rank of the channels is 3.
std::array<int, 3> hosvdRanks(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget);
/// The truncated higher-order SVD: a core tensor of the ranks times a matrix with orthonormal columns per mode. De
/// Lathauwer, De Moor and Vandewalle 2000, "A Multilinear Singular Value Decomposition". Under a second.
/// @param ranks each at most the size of its mode.
HalfDifferenceTensor decomposeHosvd(const HalfDifferenceTensor& tensor, const std::array<int, 3>& ranks);

/// The number of coefficients of a cosine series that fits in the budget, from 1 to all.
std::size_t cosineCoefficients(const factorization::HalfDifferenceAxes& axes, std::size_t byteBudget);
/// The largest coefficients of the orthonormal discrete cosine transform (type II) over the nodes of all four modes.
/// Ahmed, Natarajan and Rao 1974, "Discrete Cosine Transform". The squared residual is the energy of the omitted
/// coefficients. A coefficient has four bytes, its position two. Tens of milliseconds.
/// @param coefficients at least 1; more than there are: all.
HalfDifferenceTensor truncateCosineSeries(const HalfDifferenceTensor& tensor, std::size_t coefficients);

/// Linear between the nodes.
std::shared_ptr<const Brdf> makeHalfDifferenceTensorBrdf(HalfDifferenceTensor tensor);

}  // namespace gonio::baselines
