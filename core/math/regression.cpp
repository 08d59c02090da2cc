// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/regression.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace gonio {

namespace {

constexpr double negligible = 1e-8;
/// Errors that differ by less than this fraction are equal but for rounding.
constexpr double minRidgeGain = 1e-9;

}  // namespace

RidgeRegression::RidgeRegression(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& values) : svd_(thinSvd(rows)) {
  assert(rows.rows() == values.rows() && rows.size() > 0);
  const double largest = svd_.singularValues[0];
  for (double& sigma : svd_.singularValues)
    if (!(sigma > negligible * largest)) sigma = 0;
  projected_ = svd_.u.transpose() * values;
  outside_ = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  if (rows.rows() > rows.cols()) outside_ = values - svd_.u * projected_;
}

Eigen::VectorXd RidgeRegression::residualFractions(double ridge) const {
  return svd_.singularValues.unaryExpr([ridge](double sigma) {
    if (sigma == 0 || std::isinf(ridge)) return 1.0;
    return ridge / (sigma * sigma + ridge);
  });
}

Eigen::MatrixXd RidgeRegression::coefficients(double ridge) const {
  const Eigen::VectorXd shrunk = svd_.singularValues.unaryExpr(
      [ridge](double sigma) { return sigma == 0 ? 0.0 : sigma / (sigma * sigma + ridge); });
  return svd_.v * (shrunk.asDiagonal() * projected_);
}

Eigen::MatrixXd RidgeRegression::leaveOneOut(double ridge) const {
  const Eigen::VectorXd residuals = residualFractions(ridge);
  const Eigen::MatrixXd residual = svd_.u * (residuals.asDiagonal() * projected_) + outside_;
  Eigen::VectorXd diagonal = svd_.u.cwiseAbs2() * residuals;
  // Rows beyond the columns: what U does not span is wholly residual.
  if (svd_.u.rows() > svd_.u.cols()) diagonal += (1 - svd_.u.rowwise().squaredNorm().array()).max(0.0).matrix();
  return diagonal.cwiseInverse().asDiagonal() * residual;
}

std::vector<double> RidgeRegression::triedRidges() const {
  const double largest = svd_.singularValues[0] * svd_.singularValues[0];
  std::vector<double> ridges;
  if (largest == 0 || rowCount() == 1) return ridges;
  for (int tenth = 30; tenth >= -70; --tenth) ridges.push_back(largest * std::pow(10.0, 0.1 * tenth));
  return ridges;
}

double RidgeRegression::leaveOneOutRidge(double otherwise) const {
  const std::vector<double> ridges = triedRidges();
  std::vector<double> sums;
  for (const double ridge : ridges) sums.push_back(leaveOneOut(ridge).squaredNorm());
  return bestRidge(ridges, sums, otherwise);
}

double RidgeRegression::weightedEnergy(double ridge) const {
  double sum = ridge > 0 ? outside_.squaredNorm() / ridge : 0;
  for (Eigen::Index k = 0; k < svd_.singularValues.size(); ++k) {
    const double denominator = svd_.singularValues[k] * svd_.singularValues[k] + ridge;
    if (denominator > 0) sum += projected_.row(k).squaredNorm() / denominator;
  }
  return sum;
}

Eigen::MatrixXd RidgeRegression::posteriorFactor(double ridge) const {
  const Eigen::VectorXd explained = 1 - residualFractions(ridge).array().sqrt();
  return Eigen::MatrixXd::Identity(svd_.v.rows(), svd_.v.rows()) - svd_.v * explained.asDiagonal() * svd_.v.transpose();
}

double bestRidge(const std::vector<double>& ridges, const std::vector<double>& sums, double otherwise) {
  double best = otherwise, least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ridges.size(); ++i) {
    if (!(sums[i] < (1 - minRidgeGain) * least)) continue;
    least = sums[i];
    best = ridges[i];
  }
  return best;
}

Lasso::Lasso(const Eigen::MatrixXd& a) : a_(a), squares_(a.colwise().squaredNorm()) {}

double Lasso::largestPenalty(const Eigen::VectorXd& b) const {
  return a_.cols() > 0 ? (a_.transpose() * b).cwiseAbs().maxCoeff() : 0;
}

void Lasso::solve(const Eigen::VectorXd& b, double lambda, Eigen::VectorXd& start) const {
  constexpr int maxSweeps = 10'000;
  constexpr double tolerance = 1e-9;
  const double smallest = tolerance * b.norm();
  Eigen::VectorXd remainder = b - a_ * start;
  for (int sweep = 0; sweep < maxSweeps; ++sweep) {
    double largest = 0;
    for (Eigen::Index i = 0; i < a_.cols(); ++i) {
      if (!(squares_[i] > 0)) continue;
      const double along = a_.col(i).dot(remainder) + squares_[i] * start[i];
      const double next = std::copysign(std::max(0.0, std::abs(along) - lambda), along) / squares_[i];
      if (next == start[i]) continue;
      remainder -= (next - start[i]) * a_.col(i);
      largest = std::max(largest, std::abs(next - start[i]) * std::sqrt(squares_[i]));
      start[i] = next;
    }
    if (largest <= smallest) return;
  }
}

}  // namespace gonio
