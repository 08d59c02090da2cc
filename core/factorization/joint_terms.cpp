// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/joint_terms.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace gonio::factorization {

namespace {

using Index = Eigen::Index;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The weight of the proximal term, in the mean diagonal entry of the equations.
constexpr double proximalFraction = 1e-7;

/// Products of the columns l <= k of a matrix, one per pair: the entries of the Gram matrices of its rows.
Eigen::MatrixXd pairProducts(const Eigen::MatrixXd& factor) {
  const Index terms = factor.cols();
  Eigen::MatrixXd pairs(factor.rows(), terms * (terms + 1) / 2);
  for (Index k = 0, pair = 0; k < terms; ++k)
    for (Index l = 0; l <= k; ++l, ++pair) pairs.col(pair) = factor.col(l).cwiseProduct(factor.col(k));
  return pairs;
}

Eigen::MatrixXd symmetricOf(const Eigen::RowVectorXd& pairs, Index terms) {
  Eigen::MatrixXd matrix(terms, terms);
  for (Index k = 0, pair = 0; k < terms; ++k)
    for (Index l = 0; l <= k; ++l, ++pair) matrix(l, k) = matrix(k, l) = pairs[pair];
  return matrix;
}

/// Minimises x^T gram x - 2 right^T x plus the proximal term about `x`; optionally with x[0] >= 0, exactly: where the
/// free minimum violates the bound, the minimum of a convex function lies on it. Returns the value without that term.
double solveEntries(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, bool firstNonnegative,
                    Eigen::Ref<Eigen::VectorXd> x) {
  const double proximal = proximalFraction * gram.trace() / double(gram.rows());
  if (!(proximal > 0)) return 0;
  const Index count = x.size();
  const Eigen::MatrixXd system = gram + proximal * Eigen::MatrixXd::Identity(count, count);
  const Eigen::VectorXd target = right + proximal * x;
  Eigen::VectorXd solution = system.llt().solve(target);
  if (firstNonnegative && solution[0] < 0) {
    solution[0] = 0;
    if (count > 1)
      solution.tail(count - 1) = system.bottomRightCorner(count - 1, count - 1).llt().solve(target.tail(count - 1));
  }
  if (solution.allFinite()) x = solution;
  return x.dot(gram * x) - 2 * right.dot(x);
}

/// A tensor with its weights as matrices, rows (i, j), columns k, and the factors of all terms, one per column.
class JointSweep {
 public:
  JointSweep(const MaskedTensor& tensor, const std::vector<RankOne>& terms, bool firstNonnegative)
      : m_(tensor.sizes[0]),
        n_(tensor.sizes[1]),
        p_(tensor.sizes[2]),
        terms_(Index(terms.size())),
        firstNonnegative_(firstNonnegative),
        squaredNorm_(tensor.squaredNorm()) {
    using Map = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
    weights_ = Map(tensor.weights.data(), m_ * n_, p_).cast<double>();
    weighted_ = Map(tensor.values.data(), m_ * n_, p_).cast<double>().cwiseProduct(weights_);
    a_.resize(m_, terms_), b_.resize(n_, terms_), c_.resize(p_, terms_);
    for (Index l = 0; l < terms_; ++l) {
      const RankOne& term = terms[std::size_t(l)];
      a_.col(l) = Eigen::Map<const Eigen::VectorXd>(term.a.data(), m_);
      b_.col(l) = Eigen::Map<const Eigen::VectorXd>(term.b.data(), n_);
      c_.col(l) = Eigen::Map<const Eigen::VectorXd>(term.c.data(), p_);
    }
    balance();
  }

  double squaredNorm() const { return squaredNorm_; }

  /// One round of updates; the squared norm of the residual after it.
  double run() {
    const Eigen::MatrixXd pairs = weights_ * pairProducts(c_), rights = weighted_ * c_;
    double value = 0;
    // The last mode is summed: rounds over the other two take little time.
    for (int round = 0; round < 2; ++round) {
      updateFirst(pairs, rights);
      value = updateSecond(pairs, rights);
    }
    if (p_ > 1) value = updateLast();
    balance();
    return squaredNorm_ + value;
  }

  void store(std::vector<RankOne>& terms) const {
    for (Index l = 0; l < terms_; ++l) {
      RankOne& term = terms[std::size_t(l)];
      const double scaleB = largestOf(b_.col(l)), scaleC = largestOf(c_.col(l)), scale = scaleB * scaleC;
      const auto divided = [](const auto& column, double divisor) {
        const Eigen::VectorXd values = column / divisor;
        return std::vector<double>(values.begin(), values.end());
      };
      term.a = divided(a_.col(l), scale != 0 ? 1 / scale : 1);
      term.b = divided(b_.col(l), scaleB != 0 ? scaleB : 1);
      term.c = divided(c_.col(l), scaleC != 0 ? scaleC : 1);
    }
  }

 private:
  /// The entry of largest absolute value, with its sign.
  static double largestOf(const Eigen::Ref<const Eigen::VectorXd>& column) {
    Index at = 0;
    column.cwiseAbs().maxCoeff(&at);
    return column[at];
  }

  void updateFirst(const Eigen::MatrixXd& pairs, const Eigen::MatrixXd& rights) {
    const Eigen::MatrixXd products = pairProducts(b_);
    for (Index i = 0; i < m_; ++i) {
      const Eigen::RowVectorXd gram = pairs.middleRows(i * n_, n_).cwiseProduct(products).colwise().sum();
      const Eigen::VectorXd right = rights.middleRows(i * n_, n_).cwiseProduct(b_).colwise().sum();
      solveRow(a_, i, gram, right);
    }
  }

  double updateSecond(const Eigen::MatrixXd& pairs, const Eigen::MatrixXd& rights) {
    const Eigen::MatrixXd products = pairProducts(a_);
    double value = 0;
    for (Index j = 0; j < n_; ++j) {
      const auto rows = Eigen::seqN(j, m_, n_);
      const Eigen::RowVectorXd gram = pairs(rows, Eigen::all).cwiseProduct(products).colwise().sum();
      const Eigen::VectorXd right = rights(rows, Eigen::all).cwiseProduct(a_).colwise().sum();
      value += solveRow(b_, j, gram, right);
    }
    return value;
  }

  double updateLast() {
    Eigen::MatrixXd products(m_ * n_, terms_);
    for (Index l = 0; l < terms_; ++l)
      for (Index i = 0; i < m_; ++i) products.col(l).segment(i * n_, n_) = a_(i, l) * b_.col(l);
    const Eigen::MatrixXd pairs = weights_.transpose() * pairProducts(products);
    const Eigen::MatrixXd rights = weighted_.transpose() * products;
    double value = 0;
    for (Index k = 0; k < p_; ++k) value += solveRow(c_, k, pairs.row(k), rights.row(k).transpose());
    return value;
  }

  double solveRow(Eigen::MatrixXd& factor, Index row, const Eigen::RowVectorXd& gram, const Eigen::VectorXd& right) {
    Eigen::VectorXd entries = factor.row(row).transpose();
    const double value = solveEntries(symmetricOf(gram, terms_), right, firstNonnegative_, entries);
    factor.row(row) = entries.transpose();
    return value;
  }

  /// The three factors of a term get the same norm, so that the proximal term weights all terms alike.
  void balance() {
    for (Index l = 0; l < terms_; ++l) {
      const double a = a_.col(l).norm(), b = b_.col(l).norm(), c = c_.col(l).norm(), all = std::cbrt(a * b * c);
      if (!(all > 0)) continue;
      a_.col(l) *= all / a, b_.col(l) *= all / b, c_.col(l) *= all / c;
    }
  }

  Index m_, n_, p_, terms_;
  bool firstNonnegative_;
  double squaredNorm_;
  RowMajor weights_, weighted_;  ///< weighted_: values times weights
  Eigen::MatrixXd a_, b_, c_;
};

/// By a direct sum.
double squaredNormOfResidual(MaskedTensor tensor, const std::vector<RankOne>& terms) {
  for (const RankOne& term : terms) subtract(tensor, term);
  return tensor.squaredNorm();
}

}  // namespace

std::vector<double> refineJointly(const MaskedTensor& tensor, std::vector<RankOne>& terms, const JointOptions& options,
                                  const TaskControl& control) {
  std::vector<double> residuals{squaredNormOfResidual(tensor, terms)};
  if (terms.empty() || !(residuals.front() > 0)) return residuals;
  JointSweep sweep(tensor, terms, options.firstNonnegative);
  for (int n = 0; n < options.maxSweeps; ++n) {
    control.throwIfStopped();
    const double before = residuals.back();
    // Rounding of the sums: a rise of its size is none.
    residuals.push_back(std::clamp(sweep.run(), 0.0, before));
    if (before - residuals.back() <= options.tolerance * before) break;
  }
  std::vector<RankOne> refined = terms;
  sweep.store(refined);
  // Near an exact fit only rounding remains, which may be worse than at the start.
  if (const double after = squaredNormOfResidual(tensor, refined); after <= residuals.front()) {
    residuals.back() = std::min(after, residuals.front());
    terms = std::move(refined);
  } else {
    residuals.resize(1);
  }
  return residuals;
}

}  // namespace gonio::factorization
