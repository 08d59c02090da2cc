// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/a_optimal_selection.h"

#include <algorithm>
#include <cmath>

#include "core/math/parallel.h"

namespace gonio::acquisition {

namespace {

using dictionary::PrincipalComponents;
using Eigen::Index;

constexpr std::size_t maxCandidates = std::size_t(1) << 18;
constexpr std::size_t blockRows = 1024;
constexpr double sampleNoise = 0.03;
/// Fraction of the initial variance that counts as none.
constexpr double noReduction = 1e-9;

class Candidates {
 public:
  Candidates(const PrincipalComponents& basis, const std::vector<std::size_t>& rows, Index components,
             const TaskControl& control)
      : deviations_(basis.svd.singularValues.head(components) / std::sqrt(double(basis.svd.v.rows()))) {
    const std::size_t step = (rows.size() + maxCandidates - 1) / maxCandidates;
    for (std::size_t i = 0; i < rows.size(); i += step) rows_.push_back(rows[i]);
    values_.resize(components, Index(rows_.size()));
    noise_.resize(rows_.size());
    used_.assign(rows_.size(), 0);
    const auto u = basis.svd.u.view().leftCols(components);
    parallelForBlocks(
        rows_.size(), blockRows,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i) {
            values_.col(Index(i)) =
                (u.row(Index(rows_[i])).transpose().cast<double>().cwiseProduct(deviations_)).cast<float>();
            noise_[i] = float(sampleNoise) + leftOutVariance(basis, int(components), rows_[i], rows_[i] + 1).front();
          }
        },
        control);
  }

  /// The candidate with the largest reduction of the sum of variances, and that reduction.
  struct Best {
    std::size_t index = 0;
    float reduction = 0;
  };
  /// @param posterior covariance of the coefficients divided by `deviations_`.
  Best best(const Eigen::MatrixXd& posterior, const TaskControl& control) const {
    const Eigen::MatrixXf covariance = posterior.cast<float>();
    const Eigen::ArrayXf variances = deviations_.array().square().cast<float>();
    std::vector<Best> found((rows_.size() + blockRows - 1) / blockRows);
    parallelForBlocks(
        rows_.size(), blockRows,
        [&](std::size_t begin, std::size_t end) {
          const auto block = values_.middleCols(Index(begin), Index(end - begin));
          const Eigen::MatrixXf covered = covariance * block;
          const Eigen::ArrayXf explained = (covered.array().square().colwise() * variances).colwise().sum().transpose();
          const Eigen::ArrayXf variance = (covered.array() * block.array()).colwise().sum().transpose();
          Best& one = found[begin / blockRows];
          for (std::size_t i = begin; i < end; ++i) {
            const float reduction =
                explained[Index(i - begin)] / (std::max(0.0f, variance[Index(i - begin)]) + noise_[i]);
            if (used_[i] == 0 && reduction > one.reduction) one = {i, reduction};
          }
        },
        control);
    return *std::ranges::max_element(found, {}, &Best::reduction);
  }

  /// The posterior after a sample at the candidate.
  void take(std::size_t index, Eigen::MatrixXd& posterior) {
    used_[index] = 1;
    const Eigen::VectorXd row = values_.col(Index(index)).cast<double>(), gain = posterior * row;
    posterior -= gain * gain.transpose() / (row.dot(gain) + double(noise_[index]));
  }

  /// Sum over all cells of the variances that the components explain: the columns of U are orthonormal.
  double totalVariance(const Eigen::MatrixXd& posterior) const {
    return posterior.diagonal().dot(deviations_.cwiseAbs2());
  }
  std::size_t row(std::size_t index) const { return rows_[index]; }
  bool areEmpty() const { return rows_.empty(); }

 private:
  Eigen::VectorXd deviations_;  ///< of the coefficients of U over the training set
  std::vector<std::size_t> rows_;
  Eigen::MatrixXf values_;  ///< rows of U times `deviations_`: components x candidates
  std::vector<float> noise_;
  std::vector<char> used_;
};

}  // namespace

AOptimalSelection chooseAOptimal(const PrincipalComponents& basis, const std::vector<std::size_t>& rows, int samples,
                                 int components, const TaskControl& control,
                                 const std::function<void(std::size_t row)>& chosen) {
  Candidates candidates(basis, rows, components, {control.stop, {}});
  AOptimalSelection result;
  Eigen::MatrixXd posterior = Eigen::MatrixXd::Identity(components, components);
  const double initial = candidates.totalVariance(posterior);
  result.residuals.push_back(initial > 0 ? 1 : 0);
  while (int(result.rows.size()) < samples && !candidates.areEmpty()) {
    const auto best = candidates.best(posterior, {control.stop, {}});
    if (!(best.reduction > noReduction * initial)) break;
    candidates.take(best.index, posterior);
    result.rows.push_back(candidates.row(best.index));
    const double left = std::sqrt(std::max(0.0, candidates.totalVariance(posterior)) / initial);
    result.residuals.push_back(std::min(result.residuals.back(), left));
    if (chosen) chosen(result.rows.back());
    control.report(double(result.rows.size()) / samples);
  }
  return result;
}

}  // namespace gonio::acquisition
