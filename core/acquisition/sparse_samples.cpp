// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sparse_samples.h"

#include <algorithm>

#include "core/math/matching_pursuit.h"

namespace gonio::acquisition {

namespace {

Eigen::VectorXd pursue(const AtomSet& atoms, const Eigen::VectorXd& signal, int steps) {
  const PursuitResult found = orthogonalMatchingPursuit(atoms, signal, {.steps = steps});
  Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(atoms.count());
  for (std::size_t a = 0; a < found.atoms.size(); ++a) coefficients[found.atoms[a]] = found.coefficients[a];
  return coefficients;
}

/// The matrix without one row.
Eigen::MatrixXd without(const Eigen::MatrixXd& matrix, Eigen::Index row) {
  Eigen::MatrixXd result(matrix.rows() - 1, matrix.cols());
  result << matrix.topRows(row), matrix.bottomRows(matrix.rows() - 1 - row);
  return result;
}

/// The number of atoms, from 1, of the least squared error of prediction, for each channel.
Eigen::Array3i bestCounts(const SampleRows& samples, int most) {
  Eigen::ArrayX3d errors = Eigen::ArrayX3d::Zero(most, 3);
  for (Eigen::Index row = 0; row < samples.rows.rows(); ++row) {
    const AtomSet atoms(without(samples.rows, row));
    const Eigen::MatrixXd values = without(samples.values, row);
    for (Eigen::Index channel = 0; channel < 3; ++channel)
      for (int count = 1; count <= most; ++count) {
        const double predicted = samples.rows.row(row).dot(pursue(atoms, values.col(channel), count));
        const double error = samples.values(row, channel) - predicted;
        errors(count - 1, channel) += error * error;
      }
  }
  Eigen::Array3i best;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    errors.col(channel).minCoeff(&best[channel]);
    ++best[channel];
  }
  return best;
}

}  // namespace

Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms) {
  const int most = std::max(1, int(samples.rows.rows()) / 2);
  Eigen::Array3i counts = Eigen::Array3i::Constant(atoms > 0 ? atoms : 1);
  if (atoms == 0 && most > 1) counts = bestCounts(samples, most);
  const AtomSet all(samples.rows);
  Eigen::MatrixXd coefficients(samples.rows.cols(), 3);
  for (Eigen::Index channel = 0; channel < 3; ++channel)
    coefficients.col(channel) = pursue(all, samples.values.col(channel), counts[channel]);
  return coefficients;
}

}  // namespace gonio::acquisition
