// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "core/acquisition/sample_selection.h"
#include "core/acquisition/sampling_plan.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"

/// Bases of random numbers, and Algorithm 4 of the dissertation in the plainest way: what the selection is checked
/// with.
namespace gonio::acquisition::test_support {

using test::randomMatrix;

inline constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 12, .thetaDCount = 9, .phiDCount = 8};

/// A rig that sees all there is.
inline const MeasurableDirections everything{.maxPolarAngle = halfPi};

/// Of random directions.
inline Eigen::MatrixXd orthonormalColumns(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  return test::orthonormalised(randomMatrix(rows, columns, seed)).leftCols(columns);
}

/// A basis with these U and V over the first cells above the horizon, every `stride`-th, each pair of directions once
/// but with `everyNode`; sigma falls by halves to 1/16.
inline dictionary::PrincipalComponents basisOf(const Eigen::MatrixXd& u, const Eigen::MatrixXd& v,
                                               const HalfDifferenceGrid& grid = smallGrid, std::size_t stride = 1,
                                               bool everyNode = false) {
  dictionary::PrincipalComponents basis;
  basis.mapping.grid = grid;
  for (std::size_t cell = 0; cell < grid.size() && Eigen::Index(basis.mapping.cells.size()) < u.rows(); cell += stride)
    if (grid.nodeAboveHorizon(cell) && (everyNode || pairNode(grid, cell) == cell))
      basis.mapping.cells.push_back(std::uint32_t(cell));
  const std::size_t count = basis.mapping.cells.size();
  basis.mapping.weights.assign(count, 1);
  basis.mapping.reference.assign(count, 1);
  basis.mean.assign(count, 0);
  const Eigen::MatrixXf single = u.topRows(Eigen::Index(count)).cast<float>();
  basis.svd.u.values.assign(single.data(), single.data() + single.size());
  basis.svd.u.rows = single.rows();
  basis.svd.u.columns = single.cols();
  basis.svd.singularValues.resize(single.cols());
  for (Eigen::Index k = 0; k < single.cols(); ++k)
    basis.svd.singularValues[k] = 100 * std::exp2(-4.0 * double(k) / double(single.cols()));
  basis.svd.v = v;
  return basis;
}

inline dictionary::PrincipalComponents randomBasis(Eigen::Index cells, Eigen::Index signals, Eigen::Index components,
                                                   unsigned seed) {
  return basisOf(orthonormalColumns(cells, components, seed), orthonormalColumns(signals, components, 1000 + seed));
}

/// Among which a selection chooses, ascending.
inline std::vector<std::uint32_t> measurableCells(const dictionary::PrincipalComponents& basis,
                                                  const MeasurableDirections& measurable) {
  const HalfDifferenceGrid& grid = basis.mapping.grid;
  std::vector<std::uint32_t> cells;
  for (const std::uint32_t cell : basis.mapping.cells)
    if (pairNode(grid, cell) == cell && measurable.allows(grid.directions(cell))) cells.push_back(cell);
  return cells;
}

/// The same by a selection of all that there are.
inline std::vector<std::uint32_t> allSelectedCells(const dictionary::PrincipalComponents& basis,
                                                   const MeasurableDirections& measurable) {
  std::vector<std::uint32_t> cells = selectSamples(basis, {.method = SelectionMethod::random,
                                                           .samples = int(basis.mapping.cells.size()),
                                                           .measurable = measurable})
                                         .cells;
  std::sort(cells.begin(), cells.end());
  return cells;
}

struct PlainPursuit {
  std::vector<std::uint32_t> cells;
  std::vector<double> residuals;
};

/// Sigma^-1 U^T of the first components, in double.
inline Eigen::MatrixXd leftInverse(const dictionary::PrincipalComponents& basis, Eigen::Index components) {
  const Eigen::MatrixXd u = basis.svd.u.view().leftCols(components).cast<double>();
  return basis.svd.singularValues.head(components).cwiseInverse().asDiagonal() * u.transpose();
}

/// The same with columns of unit length.
inline Eigen::MatrixXd unitAtoms(const dictionary::PrincipalComponents& basis, Eigen::Index components) {
  Eigen::MatrixXd atoms = leftInverse(basis, components);
  for (Eigen::Index i = 0; i < atoms.cols(); ++i)
    if (atoms.col(i).norm() > 0) atoms.col(i) /= atoms.col(i).norm();
  return atoms;
}

/// Every score anew, every residual by a solution of least squares of its own.
inline PlainPursuit plainPursuit(const dictionary::PrincipalComponents& basis, Eigen::Index components,
                                 Eigen::Index signals, int samples, const std::vector<std::uint32_t>& allowed,
                                 bool normalised = true) {
  const Eigen::MatrixXd atoms = normalised ? unitAtoms(basis, components) : leftInverse(basis, components);
  const Eigen::MatrixXd s = basis.svd.v.topLeftCorner(signals, components).transpose();
  const std::set<std::uint32_t> open(allowed.begin(), allowed.end());
  PlainPursuit result{.residuals = {1.0}};
  Eigen::MatrixXd residual = s, support(components, 0);
  for (int step = 0; step < samples && residual.norm() > 1e-10 * s.norm(); ++step) {
    Eigen::Index best = -1;
    double most = 0;
    for (Eigen::Index i = 0; i < atoms.cols(); ++i) {
      const std::uint32_t cell = basis.mapping.cells[std::size_t(i)];
      const bool known = std::find(result.cells.begin(), result.cells.end(), cell) != result.cells.end();
      if (known || !open.contains(cell)) continue;
      double score = 0;
      for (Eigen::Index c = 0; c < residual.cols(); ++c) score += std::abs(atoms.col(i).dot(residual.col(c)));
      if (score > most) {
        most = score;
        best = i;
      }
    }
    if (best < 0) break;
    support.conservativeResize(Eigen::NoChange, step + 1);
    support.col(step) = atoms.col(best);
    residual = s - support * test::leastSquares(support, s);
    result.cells.push_back(basis.mapping.cells[std::size_t(best)]);
    result.residuals.push_back(residual.norm() / s.norm());
  }
  return result;
}

/// What has to hold of any selection: distinct cells among those allowed.
inline bool isDistinctAmong(const std::vector<std::uint32_t>& cells, const std::vector<std::uint32_t>& allowed) {
  const std::set<std::uint32_t> distinct(cells.begin(), cells.end());
  return distinct.size() == cells.size() &&
         std::includes(allowed.begin(), allowed.end(), distinct.begin(), distinct.end());
}

}  // namespace gonio::acquisition::test_support
