// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/condition_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "core/acquisition/unguided_selection.h"
#include "core/math/decompositions.h"
#include "core/math/parallel.h"

namespace gonio::acquisition {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr std::int32_t none = -1;
/// A Gram matrix squares the condition number: beyond this one its smallest eigenvalue has lost half its digits.
constexpr double trusted = 1e4;

/// The candidates on the grid.
class CandidateGrid {
 public:
  CandidateGrid(const dictionary::PrincipalComponents& basis, const std::vector<std::size_t>& rows)
      : grid_(basis.mapping.grid), cells_(basis.mapping.cells), rowOf_(grid_.size(), none) {
    for (const std::size_t row : rows) rowOf_[cells_[row]] = std::int32_t(row);
  }

  /// The rows of a row's neighbours: `none` where there is no candidate.
  std::array<std::int32_t, 6> neighbours(std::size_t row) const {
    const int phis = grid_.phiDCount, thetaDs = grid_.thetaDCount;
    const int k = int(cells_[row]) % phis, j = int(cells_[row]) / phis % thetaDs, i = int(cells_[row]) / phis / thetaDs;
    return {at(i - 1, j, k),         at(i + 1, j, k), at(i, j - 1, k), at(i, j + 1, k), at(i, j, (k + phis - 1) % phis),
            at(i, j, (k + 1) % phis)};
  }

 private:
  std::int32_t at(int i, int j, int k) const {
    const bool inside = i >= 0 && i < grid_.thetaHCount && j >= 0 && j < grid_.thetaDCount;
    return inside ? rowOf_[grid_.index(i, j, k)] : none;
  }

  HalfDifferenceGrid grid_;
  const std::vector<std::uint32_t>& cells_;
  std::vector<std::int32_t> rowOf_;
};

/// The Gram matrix M^T M of chosen rows and its eigenvectors.
struct Spectrum {
  Eigen::MatrixXd gram;
  EigenBasis basis;
  double condition = infinite;

  explicit Spectrum(const Eigen::MatrixXd& rows) : gram(rows.transpose() * rows), basis(eigenBasis(gram)) {
    const double largest = basis.values[0], smallest = basis.values[basis.values.size() - 1];
    if (largest < trusted * trusted * smallest) {
      condition = std::sqrt(largest / smallest);
    } else {
      const Eigen::VectorXd values = thinSvd(rows).singularValues;
      const double least = values[values.size() - 1];
      condition = least > values[0] * std::numeric_limits<double>::epsilon() ? values[0] / least : infinite;
    }
  }

  /// A lower bound of the condition number when row `out` gives way to `in`: no Rayleigh quotient is above the largest
  /// eigenvalue or below the smallest. 0 where rounding decides.
  double boundAfter(const Eigen::VectorXd& out, const Eigen::VectorXd& in) const {
    if (condition > trusted) return 0;
    const Eigen::Index last = basis.values.size() - 1;
    const auto quotient = [&](Eigen::Index k) {
      const double lost = basis.vectors.col(k).dot(out), gained = basis.vectors.col(k).dot(in);
      return basis.values[k] - lost * lost + gained * gained;
    };
    return quotient(last) > 0 ? std::sqrt(std::max(0.0, quotient(0)) / quotient(last)) : infinite;
  }
};

/// One search from random rows.
class Search {
 public:
  Search(const dictionary::PrincipalComponents& basis, const CandidateGrid& grid, std::vector<std::size_t> start)
      : basis_(basis),
        grid_(grid),
        rows_(std::move(start)),
        components_(std::min<Eigen::Index>(Eigen::Index(rows_.size()), basis.count())) {
    matrix_.resize(Eigen::Index(rows_.size()), components_);
    for (std::size_t i = 0; i < rows_.size(); ++i) matrix_.row(Eigen::Index(i)) = dictionaryRow(rows_[i]).transpose();
  }

  ConditionSearchResult run(const TaskControl& control) {
    Spectrum spectrum(matrix_);
    std::size_t still = 0;  // rows in a row that no move helps
    for (std::size_t i = 0; still < rows_.size(); i = (i + 1) % rows_.size()) {
      control.throwIfStopped();
      const bool moved = moveRow(i, spectrum);
      still = moved ? 0 : still + 1;
    }
    return {.rows = rows_, .conditionNumber = spectrum.condition};
  }

 private:
  Eigen::VectorXd dictionaryRow(std::size_t row) const {
    return basis_.svd.u.view()
        .row(Eigen::Index(row))
        .head(components_)
        .transpose()
        .cast<double>()
        .cwiseProduct(basis_.svd.singularValues.head(components_));
  }

  /// Moves row i to the best of the neighbours that lower the condition number; false if there is none.
  bool moveRow(std::size_t i, Spectrum& spectrum) {
    const Eigen::VectorXd old = matrix_.row(Eigen::Index(i)).transpose();
    std::size_t best = rows_[i];
    Spectrum lowest = spectrum;
    for (const std::int32_t neighbour : grid_.neighbours(rows_[i])) {
      if (neighbour == none || std::find(rows_.begin(), rows_.end(), std::size_t(neighbour)) != rows_.end()) continue;
      const Eigen::VectorXd row = dictionaryRow(std::size_t(neighbour));
      if (spectrum.boundAfter(old, row) >= lowest.condition) continue;
      matrix_.row(Eigen::Index(i)) = row.transpose();
      Spectrum moved(matrix_);
      if (moved.condition >= lowest.condition) continue;
      lowest = std::move(moved);
      best = std::size_t(neighbour);
    }
    const bool moves = best != rows_[i];
    rows_[i] = best;
    matrix_.row(Eigen::Index(i)) = dictionaryRow(best).transpose();
    if (moves) spectrum = std::move(lowest);
    return moves;
  }

  const dictionary::PrincipalComponents& basis_;
  const CandidateGrid& grid_;
  std::vector<std::size_t> rows_;
  Eigen::Index components_;
  Eigen::MatrixXd matrix_;
};

/// With one component the norm of a row is the size of its only entry.
ConditionSearchResult longestRow(const dictionary::PrincipalComponents& basis, const std::vector<std::size_t>& rows) {
  const auto u = basis.svd.u.view();
  const auto longest = *std::max_element(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(u(Eigen::Index(a), 0)) < std::abs(u(Eigen::Index(b), 0));
  });
  return {.rows = {longest}, .conditionNumber = u(Eigen::Index(longest), 0) != 0 ? 1 : infinite};
}

}  // namespace

ConditionSearchResult searchByCondition(const dictionary::PrincipalComponents& basis,
                                        const std::vector<std::size_t>& rows, int samples, std::uint64_t seed,
                                        int restarts, const TaskControl& control) {
  const std::size_t count = std::min(std::size_t(samples), rows.size());
  if (count == 1) return longestRow(basis, rows);
  const CandidateGrid grid(basis, rows);
  std::vector<ConditionSearchResult> results(std::size_t(std::max(1, restarts)));
  // Neighbouring seeds share no start.
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> seeds(results.size());
  for (std::uint64_t& startSeed : seeds) startSeed = random();
  parallelForBlocks(
      results.size(), 1,
      [&](std::size_t start, std::size_t) {
        std::vector<std::size_t> chosen = randomIndices(rows.size(), count, seeds[start]);
        for (std::size_t& index : chosen) index = rows[index];
        results[start] = Search(basis, grid, std::move(chosen)).run(control);
      },
      control);
  return *std::min_element(results.begin(), results.end(),
                           [](const auto& a, const auto& b) { return a.conditionNumber < b.conditionNumber; });
}

}  // namespace gonio::acquisition
