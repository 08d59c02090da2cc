// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/condition_search.h"

#include <QTest>
#include <numeric>

#include "core/acquisition/unguided_selection.h"
#include "core/math/parallel.h"
#include "core/support/error.h"
#include "tests/core/acquisition/selection_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace condition_search_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::acquisition::test_support;

using Rows = std::vector<std::size_t>;

Rows allRows(const dictionary::PrincipalComponents& basis) {
  Rows rows(basis.mapping.cells.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  return rows;
}

/// By a full singular value decomposition.
double conditionOf(const dictionary::PrincipalComponents& basis, const Rows& rows) {
  const auto components = std::min<Eigen::Index>(Eigen::Index(rows.size()), basis.count());
  Eigen::MatrixXd matrix(Eigen::Index(rows.size()), components);
  for (std::size_t i = 0; i < rows.size(); ++i)
    matrix.row(Eigen::Index(i)) = basis.svd.u.view().row(Eigen::Index(rows[i])).head(components).cast<double>();
  matrix *= basis.svd.singularValues.head(components).asDiagonal();
  const Eigen::VectorXd values = test::singularValues(matrix);
  return values[0] / values[components - 1];
}

/// The rows next to a row, by their coordinates on the grid.
Rows neighbours(const dictionary::PrincipalComponents& basis, std::size_t row) {
  const HalfDifferenceGrid& g = basis.mapping.grid;
  const auto coordinates = [&](std::size_t other) {
    const int cell = int(basis.mapping.cells[other]);
    return std::array{cell / g.phiDCount / g.thetaDCount, cell / g.phiDCount % g.thetaDCount, cell % g.phiDCount};
  };
  const auto at = coordinates(row);
  Rows result;
  for (std::size_t other = 0; other < basis.mapping.cells.size(); ++other) {
    const auto there = coordinates(other);
    const int phi = std::abs(there[2] - at[2]);
    if (std::abs(there[0] - at[0]) + std::abs(there[1] - at[1]) + std::min(phi, g.phiDCount - phi) == 1)
      result.push_back(other);
  }
  return result;
}

/// The search as documented, each move by its own decomposition.
Rows plainSearch(const dictionary::PrincipalComponents& basis, Rows rows) {
  double condition = conditionOf(basis, rows);
  for (bool moves = true; moves;) {
    moves = false;
    for (std::size_t& row : rows) {
      const std::size_t old = row;
      std::size_t best = old;
      for (const std::size_t neighbour : neighbours(basis, old)) {
        if (std::find(rows.begin(), rows.end(), neighbour) != rows.end()) continue;
        row = neighbour;
        const double moved = conditionOf(basis, rows);
        row = old;
        if (!(moved < condition)) continue;
        condition = moved;
        best = neighbour;
      }
      moves = moves || best != old;
      row = best;
    }
  }
  return rows;
}

/// Rows that change smoothly over the grid, as those of materials do.
dictionary::PrincipalComponents smoothBasis(int components, unsigned seed) {
  auto basis = randomBasis(700, 60, components, seed);
  const Eigen::MatrixXd waves = randomMatrix(3, components, seed + 1);
  for (std::size_t row = 0; row < basis.mapping.cells.size(); ++row) {
    const HalfDifference at = smallGrid.node(basis.mapping.cells[row]);
    for (Eigen::Index k = 0; k < components; ++k)
      basis.svd.u.values[std::size_t(k) * basis.mapping.cells.size() + row] = float(std::cos(
          double(k) * (at.thetaH * waves(0, k) + at.thetaD * waves(1, k)) + std::sin(2 * at.phiD) * waves(2, k)));
  }
  return basis;
}

/// The rows from which a search over all rows begins.
std::vector<Rows> startsOf(const dictionary::PrincipalComponents& basis, int samples, unsigned seed, int restarts) {
  std::mt19937_64 random(seed);
  std::vector<Rows> starts;
  for (int i = 0; i < restarts; ++i)
    starts.push_back(randomIndices(basis.mapping.cells.size(), std::size_t(samples), random()));
  return starts;
}

class ConditionSearchTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void equalsPlainSearch() {
    for (unsigned seed = 1; seed <= 6; ++seed)
      for (const int samples : {2, 5, 8}) {
        const auto basis = smoothBasis(8, seed);
        const Rows rows = allRows(basis);
        const auto found = searchByCondition(basis, rows, samples, seed, 1);
        const Rows start = startsOf(basis, samples, seed, 1)[0];
        const Rows expected = plainSearch(basis, start);
        QVERIFY(expected != start);
        QVERIFY(found.rows == expected);
        QVERIFY(std::abs(found.conditionNumber - conditionOf(basis, expected)) < 1e-6 * found.conditionNumber);
      }
  }

  /// Never worse than its starts, and no single move betters the end.
  void endsInALocalMinimum() {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const auto basis = smoothBasis(10, seed);
      const auto found = searchByCondition(basis, allRows(basis), 6, seed, 3);
      for (const Rows& start : startsOf(basis, 6, seed, 3))
        QVERIFY(found.conditionNumber <= conditionOf(basis, start) * (1 + 1e-9));
      QCOMPARE((std::set<std::size_t>(found.rows.begin(), found.rows.end()).size()), std::size_t(6));
      for (std::size_t i = 0; i < 6; ++i)
        for (const std::size_t neighbour : neighbours(basis, found.rows[i])) {
          if (std::find(found.rows.begin(), found.rows.end(), neighbour) != found.rows.end()) continue;
          Rows moved = found.rows;
          moved[i] = neighbour;
          QVERIFY(conditionOf(basis, moved) >= found.conditionNumber * (1 - 1e-9));
        }
    }
  }

  /// Whatever its sign.
  void oneRowIsTheLongest() {
    auto basis = randomBasis(200, 30, 5, 9);
    Eigen::Index longest = 0;
    basis.svd.u.view().col(0).cwiseAbs().maxCoeff(&longest);
    for (const float sign : {1.0f, -1.0f}) {
      float& entry = basis.svd.u.values[std::size_t(longest)];
      entry = sign * std::abs(entry);
      const auto found = searchByCondition(basis, allRows(basis), 1, 1, 5);
      QCOMPARE(found.rows, Rows{std::size_t(longest)});
      QVERIFY(found.conditionNumber == 1);
    }
  }

  /// Where most rows are the same any start is singular: any move to independent rows is taken.
  void leavesSingularRows() {
    auto basis = smoothBasis(3, 2);
    for (std::size_t row = 0; row < basis.mapping.cells.size(); ++row)
      if (basis.mapping.cells[row] % 3 != 0)
        for (std::size_t k = 0; k < 3; ++k) basis.svd.u.values[k * basis.mapping.cells.size() + row] = 0;
    int singular = 0;
    for (unsigned seed = 1; seed <= 30; ++seed) {
      const auto found = searchByCondition(basis, allRows(basis), 3, seed, 1);
      if (conditionOf(basis, startsOf(basis, 3, seed, 1)[0]) < 1e12) continue;
      singular += std::isfinite(found.conditionNumber);
    }
    QVERIFY(singular > 0);
  }

  void moreRestartsAreNotWorse() {
    const auto basis = smoothBasis(10, 5);
    double last = std::numeric_limits<double>::infinity();
    for (const int restarts : {1, 2, 5, 10}) {
      const double condition = searchByCondition(basis, allRows(basis), 7, 1, restarts).conditionNumber;
      QVERIFY(condition <= last);
      last = condition;
    }
  }

  void deterministicForASeedAndAnyThreads() {
    const auto basis = smoothBasis(10, 5);
    const auto search = [&](std::uint64_t seed) { return searchByCondition(basis, allRows(basis), 7, seed, 4).rows; };
    const Rows rows = search(3);
    QVERIFY(search(4) != rows);
    for (const int threads : {1, 2, 3}) {
      const ThreadLimit limit(threads);
      QCOMPARE(search(3), rows);
    }
  }

  /// Between the searches: the first of four reports its progress, and nothing comes after the stop.
  void cancelled() {
    const auto basis = smoothBasis(10, 5);
    const ThreadLimit oneThread(1);
    std::stop_source source;
    std::vector<double> reported;
    const auto stopAtOnce = [&](double share) {
      reported.push_back(share);
      source.request_stop();
    };
    QVERIFY_EXCEPTION_THROWN(searchByCondition(basis, allRows(basis), 7, 1, 4, {source.get_token(), stopAtOnce}),
                             Cancelled);
    QCOMPARE(reported.size(), std::size_t(1));
    QVERIFY(reported[0] > 0 && reported[0] < 1);
  }
};

GONIO_TEST(ConditionSearchTest)
}  // namespace condition_search_test

#include "condition_search_test.moc"
