// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/canonical_polyadic.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

#include "core/math/decompositions.h"

namespace gonio::factorization {

Eigen::MatrixXd leadingSingularVectors(const Tensor& tensor, int mode, int count) {
  assert(count >= 1 && count <= tensor.size(mode));
  const Eigen::MatrixXd fibres = unfold(tensor, mode);
  Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(fibres.rows(), fibres.rows());
  gram.selfadjointView<Eigen::Lower>().rankUpdate(fibres);
  return eigenBasis(gram).vectors.leftCols(count);
}

HigherOrderSvd decomposeHigherOrderSvd(const Tensor& tensor, const std::vector<int>& ranks) {
  assert(int(ranks.size()) == tensor.modes());
  HigherOrderSvd result{.core = tensor, .factors = {}};
  for (int mode = 0; mode < tensor.modes(); ++mode) {
    result.factors.push_back(leadingSingularVectors(tensor, mode, ranks[std::size_t(mode)]));
    result.core = transposedModeProduct(result.core, result.factors.back(), mode);
  }
  return result;
}

Tensor compose(const HigherOrderSvd& decomposition) {
  Tensor result = decomposition.core;
  for (std::size_t mode = 0; mode < decomposition.factors.size(); ++mode)
    result = modeProduct(result, decomposition.factors[mode], int(mode));
  return result;
}

namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// `values` of the given sizes, contracted with a vector along one mode, which disappears.
Vector contract(const Vector& values, std::vector<int>& sizes, std::size_t mode, const Vector& along) {
  Eigen::Index before = 1, behind = 1;
  for (std::size_t i = 0; i < mode; ++i) before *= sizes[i];
  for (std::size_t i = mode + 1; i < sizes.size(); ++i) behind *= sizes[i];
  Vector result(before * behind);
  for (Eigen::Index slab = 0; slab < behind; ++slab)
    result.segment(slab * before, before).noalias() =
        Eigen::Map<const Matrix>(values.data() + slab * before * along.size(), before, along.size()) * along;
  sizes.erase(sizes.begin() + std::ptrdiff_t(mode));
  return result;
}

/// X_(mode) times the Khatri-Rao product of all other factors: first the outermost of these for all components at once,
/// then the rest one component a time.
Matrix unfoldingTimesKhatriRao(const Tensor& tensor, const std::vector<Matrix>& factors, int mode) {
  const int last = tensor.modes() - 1, outer = mode == last ? 0 : last;
  const Matrix& outerFactor = factors[std::size_t(outer)];
  const auto along = Eigen::Index(tensor.size(outer)), rest = Eigen::Index(tensor.count()) / along;
  Matrix partial(rest, outerFactor.cols());
  if (outer == 0)
    partial.noalias() = Eigen::Map<const Matrix>(tensor.data(), along, rest).transpose() * outerFactor;
  else
    partial.noalias() = Eigen::Map<const Matrix>(tensor.data(), rest, along) * outerFactor;
  Matrix result(tensor.size(mode), outerFactor.cols());
  for (Eigen::Index r = 0; r < outerFactor.cols(); ++r) {
    std::vector<int> sizes = tensor.sizes();
    sizes.erase(sizes.begin() + outer);
    Vector values = partial.col(r);
    for (int other = last; other >= 0; --other) {
      if (other == mode || other == outer) continue;
      values = contract(values, sizes, std::size_t(outer == 0 ? other - 1 : other), factors[std::size_t(other)].col(r));
    }
    result.col(r) = values;
  }
  return result;
}

/// right * inverse(gram) for a positive semi-definite matrix; directions that it does not see are left out.
Matrix solveFromRight(const Matrix& right, const Matrix& gram) {
  const EigenBasis basis = eigenBasis(gram);
  const double smallest = 1e-14 * double(gram.rows()) * basis.values[0];
  Vector inverse = basis.values;
  for (double& value : inverse) value = value > smallest ? 1 / value : 0;
  return right * basis.vectors * inverse.asDiagonal() * basis.vectors.transpose();
}

void normaliseColumns(Matrix& factor, Vector& weights) {
  for (Eigen::Index r = 0; r < factor.cols(); ++r) {
    weights[r] = factor.col(r).norm();
    if (weights[r] > 0) factor.col(r) /= weights[r];
  }
}

Matrix gramProduct(const std::vector<Matrix>& grams, int without) {
  Matrix product = Matrix::Ones(grams[0].rows(), grams[0].cols());
  for (std::size_t i = 0; i < grams.size(); ++i)
    if (int(i) != without) product = product.cwiseProduct(grams[i]);
  return product;
}

void orientSigns(CanonicalPolyadic& result) {
  Matrix& last = result.factors.back();
  for (std::size_t mode = 0; mode + 1 < result.factors.size(); ++mode)
    for (Eigen::Index r = 0; r < last.cols(); ++r) {
      auto column = result.factors[mode].col(r);
      Eigen::Index largest = 0;
      column.cwiseAbs().maxCoeff(&largest);
      if (column[largest] >= 0) continue;
      column = -column;
      last.col(r) = -last.col(r);
    }
}

std::vector<Matrix> startFactors(const Tensor& tensor, int rank, unsigned seed, bool random) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<Matrix> factors;
  for (int mode = 0; mode < tensor.modes(); ++mode) {
    Matrix factor(tensor.size(mode), rank);
    for (double& value : factor.reshaped()) value = std::abs(normal(generator));
    const int known = random ? 0 : std::min(rank, tensor.size(mode));
    if (known > 0) factor.leftCols(known) = leadingSingularVectors(tensor, mode, known);
    Vector ignored(rank);
    normaliseColumns(factor, ignored);
    factors.push_back(std::move(factor));
  }
  return factors;
}

class Alternation {
 public:
  Alternation(const Tensor& tensor, std::vector<Matrix> factors) : tensor_(tensor), norm_(tensor.norm()) {
    result_.factors = std::move(factors);
    result_.weights = Vector::Zero(result_.factors[0].cols());
    for (const Matrix& factor : result_.factors) grams_.push_back(factor.transpose() * factor);
  }

  void run(const CanonicalPolyadicOptions& options, const TaskControl& control) {
    double before = -1;
    while (result_.iterations < options.maxIterations && !result_.converged) {
      control.throwIfStopped();
      const double fit = sweep();
      ++result_.iterations;
      result_.converged = std::abs(fit - before) < options.tolerance;
      before = fit;
      control.report(double(result_.iterations) / options.maxIterations);
    }
  }
  CanonicalPolyadic& result() { return result_; }

 private:
  /// Updates every factor; the fit from the last product, without a residual tensor.
  double sweep() {
    Matrix product;
    for (int mode = 0; mode < tensor_.modes(); ++mode) {
      Matrix& factor = result_.factors[std::size_t(mode)];
      product = unfoldingTimesKhatriRao(tensor_, result_.factors, mode);
      factor = solveFromRight(product, gramProduct(grams_, mode));
      normaliseColumns(factor, result_.weights);
      grams_[std::size_t(mode)] = factor.transpose() * factor;
    }
    const double inner = (product.cwiseProduct(result_.factors.back()) * result_.weights).sum();
    const double squared = result_.weights.dot(gramProduct(grams_, -1) * result_.weights);
    return 1 - std::sqrt(std::max(0.0, norm_ * norm_ + squared - 2 * inner)) / norm_;
  }

  const Tensor& tensor_;
  double norm_;
  std::vector<Matrix> grams_;
  CanonicalPolyadic result_;
};

double exactFit(const Tensor& tensor, const CanonicalPolyadic& decomposition) {
  Tensor residual = compose(decomposition);
  for (std::size_t i = 0; i < residual.count(); ++i) residual[i] -= tensor[i];
  return 1 - residual.norm() / tensor.norm();
}

}  // namespace

CanonicalPolyadic decomposeCanonicalPolyadic(const Tensor& tensor, int rank, const CanonicalPolyadicOptions& options,
                                             const TaskControl& control) {
  assert(rank >= 1 && tensor.modes() >= 2);
  if (tensor.norm() == 0) {
    CanonicalPolyadic zero{.weights = Vector::Zero(rank), .factors = {}, .fit = 1, .iterations = 0, .converged = true};
    for (int mode = 0; mode < tensor.modes(); ++mode) {
      zero.factors.push_back(Matrix::Zero(tensor.size(mode), rank));
      zero.factors.back().row(0).setOnes();
    }
    return zero;
  }
  const auto alternate = [&](bool random) {
    Alternation alternation(tensor, startFactors(tensor, rank, options.seed, random));
    alternation.run(options, control);
    return std::move(alternation.result());
  };
  CanonicalPolyadic result = alternate(false);
  // Components that grow against each other without end: another start.
  constexpr double maxWeight = 1e6;
  if (!(result.weights.cwiseAbs().maxCoeff() <= maxWeight * tensor.norm())) result = alternate(true);
  orientSigns(result);
  result.fit = exactFit(tensor, result);
  return result;
}

Tensor compose(const CanonicalPolyadic& decomposition) {
  std::vector<int> sizes;
  for (const Matrix& factor : decomposition.factors) sizes.push_back(int(factor.rows()));
  // The unfolding along the first mode: A_1 diag(weights) (A_N (.) ... (.) A_2)^T.
  Matrix behind = decomposition.factors.back();
  for (std::size_t mode = decomposition.factors.size() - 1; mode-- > 1;)
    behind = khatriRaoProduct(behind, decomposition.factors[mode]);
  return fold(decomposition.factors[0] * decomposition.weights.asDiagonal() * behind.transpose(), 0, sizes);
}

}  // namespace gonio::factorization
