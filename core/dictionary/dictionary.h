// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <Eigen/Core>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "core/brdf/data_transform.h"
#include "core/coordinates/half_difference_grid.h"
#include "core/dictionary/largest_projections.h"

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

/// The dictionary for signals over the whole circle of phi_d. They are the sum of a part that is the same in both
/// orders of the directions and one that changes its sign; each atom u of mode 0 becomes (u, u) / sqrt 2 (number 2a)
/// and (u, -u) / sqrt 2 (number 2a + 1), so that both parts have codes over the same dictionary, whose coefficients
/// compete for places by their size. Orthonormal if the dictionary is.
Dictionary inBothOrders(const Dictionary& dictionary);
/// The ensemble of these, over HalfDifferenceGrid::wholeCircle(). 32 dictionaries of a MERL grid have 37 MB.
Ensemble inBothOrders(const Ensemble& ensemble);

/// The dictionaries of both ensembles, first those of `first`. @throws Error if their grids or their cell scaling
/// differ.
Ensemble joined(Ensemble first, const Ensemble& second);

/// Largest absolute entry of U^T U - I over all matrices.
double orthonormalityError(const Ensemble& ensemble);
double orthonormalityError(const Eigen::MatrixXd& matrix);

/// Orthonormalises a matrix that is orthonormal up to single-precision rounding: one Newton-Schulz step, U (3 I - U^T
/// U) / 2, which squares the error.
Eigen::MatrixXd polished(const Eigen::MatrixXd& nearlyOrthonormal);

/// One channel of a material: a few coefficients over one dictionary. Like a cell of a table, the coefficient of the
/// atoms l0, l1, l2 of the three modes has the index l0 + n0 (l1 + n1 l2), with n the sizes of the modes.
struct ChannelCode {
  int dictionary = 0;
  std::vector<Coefficient<float>> coefficients;  ///< by decreasing absolute value
  /// Bounds of the transformed values: the largest and the smallest of the measurement, the latter at most 0. A sum of
  /// few atoms overshoots in cells with a small factor of cell scaling, and the inverse of the logarithm would amplify
  /// that.
  float highest = std::numeric_limits<float>::max(), lowest = 0;
  /// Bound of the absolute BRDF values, 1/sr: the largest of the measurement if SparseCode::hasLargestValues. The
  /// inverse of the cosine-weighted logarithm divides by a weight of down to 1e-3, so that values up to 1000 times the
  /// measured ones are within the bounds of the transformed values.
  float largestValue = std::numeric_limits<float>::max();
  float step = 0;  ///< of which all values are multiples (quantised()); 0: not quantised
};

/// A material as a sparse code over an ensemble: red, green, blue.
struct SparseCode {
  HalfDifferenceGrid grid;  ///< of the ensemble, or its wholeCircle(): then over inBothOrders() of the dictionaries
  DataTransform transform = DataTransform::logPlus;
  bool scaled = true;             ///< whether it represents signals with cell scaling (GridGeometry::cellScaling)
  bool hasLargestValues = false;  ///< whether ChannelCode::largestValue is part of the code; of all cosine-log codes
                                  ///< since November 2026
  std::array<ChannelCode, 3> channels;

  /// The largest number of coefficients of a channel.
  std::size_t coefficients() const;
  /// The code with only the largest `coefficients` of each channel.
  SparseCode truncated(std::size_t coefficients) const;
  bool hasBothOrders() const { return !grid.reciprocal; }
};

/// The same material as a code over the whole circle of phi_d; the code itself if it is one.
SparseCode inBothOrders(const SparseCode& code);
/// The dictionary of a channel of a code. Precondition: checkCode().
Dictionary dictionaryOf(const Ensemble& ensemble, const SparseCode& code, std::size_t channel);

}  // namespace gonio::dictionary
