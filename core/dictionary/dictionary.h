// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/coordinates/half_difference_grid.h"

/// Sparse codes over an ensemble of small orthonormal dictionaries: Miandji et al., "Compressive Image Reconstruction
/// in Reduced Union of Subspaces" (2015), "A Unified Framework for Compression and Compressed Sensing of Light Fields
/// and Light Field Videos" (2019), for measured BRDFs dissertation 4.3.2.
///
/// The modes are those of a table in memory: 0 phi_d (runs fastest), 1 theta_d, 2 theta_h.
namespace gonio::dictionary {

/// Three square orthonormal matrices: a table Y is the sum over l of S(l0, l1, l2) u0_l0 o u1_l1 o u2_l2.
struct Dictionary {
  std::array<Eigen::MatrixXd, 3> modes;  ///< mode's size x the same; the columns are the atoms
  int sparsity = 0;                      ///< coefficients a signal was allowed while it was trained
};

/// The aggregated ensemble: all dictionaries, of every trained sparsity.
struct Ensemble {
  HalfDifferenceGrid grid;
  std::vector<Dictionary> dictionaries;
  std::vector<std::string> learnedFrom;  ///< names of the materials

  /// In single precision, as the file holds it.
  std::size_t bytes() const;
};

inline std::array<int, 3> modeSizes(const HalfDifferenceGrid& grid) {
  return {grid.phiDCount, grid.thetaDCount, grid.thetaHCount};
}

/// Largest entry in size of U^T U - I over all matrices.
double orthonormalityError(const Ensemble& ensemble);
double orthonormalityError(const Eigen::MatrixXd& matrix);

/// The nearest orthonormal matrix to one that is so up to the rounding of single precision: one step of Newton and
/// Schulz, U (3 I - U^T U) / 2, whose error is the square of the former one.
Eigen::MatrixXd polished(const Eigen::MatrixXd& nearlyOrthonormal);

}  // namespace gonio::dictionary
