// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/sparse_samples.h"

#include <algorithm>

#include "core/math/incremental_qr.h"
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

/// What pursuits of 1 to `most` steps predict for a row that they have not seen. The atoms of fewer steps are the first
/// ones of more, so one pursuit gives all: with A = Q R of the chosen columns and x their entries in the row, least
/// squares over the first k predict the sum of the first k entries of R^-T x times Q^T signal.
Eigen::ArrayXd predictions(const AtomSet& atoms, const Eigen::VectorXd& signal, const Eigen::RowVectorXd& row,
                           int most) {
  const PursuitResult found = orthogonalMatchingPursuit(atoms, signal, {.steps = most});
  IncrementalQr qr(atoms.length(), Eigen::Index(found.atoms.size()));
  Eigen::VectorXd along(Eigen::Index(found.atoms.size()));  // R^-T x
  Eigen::ArrayXd result(most);
  double sum = 0;
  for (int step = 0; step < most; ++step) {
    // A pursuit that ended before answers any larger number of steps with what it has.
    if (step < int(found.atoms.size())) {
      const int atom = found.atoms[std::size_t(step)];
      qr.append(atoms.matrix().col(atom));
      const auto newest = qr.r().col(step);
      along[step] = (row[atom] - newest.head(step).dot(along.head(step))) / newest[step];
      sum += along[step] * qr.q().col(step).dot(signal);
    }
    result[step] = sum;
  }
  return result;
}

/// The number of atoms, from 1, of the least squared error of prediction, for each channel.
Eigen::Array3i bestCounts(const SampleRows& samples, int most, const TaskControl& control) {
  const Eigen::Index count = samples.rows.rows();
  Eigen::ArrayX3d errors = Eigen::ArrayX3d::Zero(most, 3);
  for (Eigen::Index row = 0; row < count; ++row) {
    const AtomSet atoms(without(samples.rows, row));
    const Eigen::MatrixXd values = without(samples.values, row);
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
      control.throwIfStopped();
      const Eigen::ArrayXd predicted = predictions(atoms, values.col(channel), samples.rows.row(row), most);
      errors.col(channel) += (samples.values(row, channel) - predicted).square();
    }
    control.report(double(row + 1) / double(count));
  }
  Eigen::Array3i best;
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    errors.col(channel).minCoeff(&best[channel]);
    ++best[channel];
  }
  return best;
}

}  // namespace

Eigen::MatrixXd sparseCoefficients(const SampleRows& samples, int atoms, const TaskControl& control) {
  const int most = std::max(1, int(samples.rows.rows()) / 2);
  Eigen::Array3i counts = Eigen::Array3i::Constant(atoms > 0 ? atoms : 1);
  if (atoms == 0 && most > 1) counts = bestCounts(samples, most, control);
  const AtomSet all(samples.rows);
  Eigen::MatrixXd coefficients(samples.rows.cols(), 3);
  for (Eigen::Index channel = 0; channel < 3; ++channel) {
    control.throwIfStopped();
    coefficients.col(channel) = pursue(all, samples.values.col(channel), counts[channel]);
  }
  return coefficients;
}

}  // namespace gonio::acquisition
