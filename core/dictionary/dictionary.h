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
/// and Light Field Videos" (2019); for measured BRDFs Tongbuasirilai 2023, "Data-Driven Approaches for Sparse
/// Reflectance Modeling and Acquisition", section 4.3.2.
///
/// Modes are the axes of a table in the order of memory: 0 phi_d (fastest), 1 theta_d, 2 theta_h.
namespace gonio::dictionary {

/// Three square orthonormal matrices. A table Y with coefficients S is the sum over l of S(l0, l1, l2) u0_l0 o u1_l1 o
/// u2_l2, where o is the outer product.
struct Dictionary {
  std::array<Eigen::MatrixXd, 3> modes;  ///< per mode size x size; the columns are the atoms
  int sparsity = 0;                      ///< number of coefficients per signal in training
};

/// The dictionaries of all trained sparsities. (In training, an ensemble is the dictionaries of one sparsity.)
struct Ensemble {
  HalfDifferenceGrid grid;
  std::vector<Dictionary> dictionaries;
  std::vector<std::string> learnedFrom;  ///< names of the training materials
  bool scaled = true;                    ///< whether the training signals had cell scaling (GridGeometry::cellScaling)

  /// Size of the dictionaries in single precision, as in the file.
  std::size_t bytes() const;
};

inline std::array<int, 3> modeSizes(const HalfDifferenceGrid& grid) {
  return {grid.phiDCount, grid.thetaDCount, grid.thetaHCount};
}

/// Largest absolute entry of U^T U - I over all matrices.
double orthonormalityError(const Ensemble& ensemble);
double orthonormalityError(const Eigen::MatrixXd& matrix);

/// Orthonormalises a matrix that is orthonormal up to single-precision rounding: one Newton-Schulz step, U (3 I - U^T
/// U) / 2, which squares the error.
Eigen::MatrixXd polished(const Eigen::MatrixXd& nearlyOrthonormal);

}  // namespace gonio::dictionary
