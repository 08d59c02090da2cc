// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/acquisition/a_optimal_selection.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/math/parallel.h"
#include "tests/core/acquisition/selection_test_support.h"
#include "tests/support/test_program.h"

namespace a_optimal_selection_test {
using namespace gonio;
using namespace gonio::acquisition;
using namespace gonio::acquisition::test_support;
using Eigen::Index, Eigen::MatrixXd;

/// Covariance of the mapped values of all cells over the training set, in the components [first, last).
MatrixXd covarianceOf(const dictionary::PrincipalComponents& basis, Index first, Index last) {
  const MatrixXd d = basis.svd.u.view().middleCols(first, last - first).cast<double>() *
                     basis.svd.singularValues.segment(first, last - first).asDiagonal();
  return d * d.transpose() / double(basis.svd.v.rows());
}

/// By the definition: the posterior covariances of all cells after each possible sample.
std::vector<std::size_t> direct(const dictionary::PrincipalComponents& basis, int samples, int components,
                                std::vector<double>& traces) {
  MatrixXd covariance = covarianceOf(basis, 0, components);
  const MatrixXd leftOut = covarianceOf(basis, components, basis.count());
  std::vector<std::size_t> rows;
  traces.push_back(covariance.trace());
  for (int sample = 0; sample < samples; ++sample) {
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t best = 0;
    MatrixXd bestCovariance;
    for (Index i = 0; i < covariance.rows(); ++i) {
      if (std::ranges::count(rows, std::size_t(i)) > 0) continue;
      const MatrixXd after =
          covariance - covariance.col(i) * covariance.row(i) / (covariance(i, i) + leftOut(i, i) + 0.03);
      if (after.trace() >= smallest) continue;
      smallest = after.trace();
      best = std::size_t(i);
      bestCovariance = after;
    }
    rows.push_back(best);
    covariance = bestCovariance;
    traces.push_back(covariance.trace());
  }
  return rows;
}

std::vector<std::size_t> allRows(const dictionary::PrincipalComponents& basis) {
  std::vector<std::size_t> rows(basis.mapping.cells.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  return rows;
}

class AOptimalSelectionTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void equalsItsDefinition() {
    for (const unsigned seed : {1u, 2u, 3u})
      for (const int components : {4, 8}) {
        auto basis = randomBasis(90, 30, 8, seed);
        basis.svd.singularValues *= 0.1;  // variances like those of mapped values
        std::vector<double> traces;
        const std::vector<std::size_t> expected = direct(basis, 12, components, traces);
        const AOptimalSelection found = chooseAOptimal(basis, allRows(basis), 12, components);
        QCOMPARE(found.rows, expected);
        QCOMPARE(found.residuals.size(), traces.size());
        for (std::size_t i = 0; i < traces.size(); ++i)
          QVERIFY(std::abs(found.residuals[i] - std::sqrt(traces[i] / traces[0])) < 1e-6);
      }
  }

  /// Only among the rows that are given; a longer plan begins with the shorter one.
  void choosesAmongTheRows() {
    const auto basis = randomBasis(90, 30, 8, 5);
    const std::vector<std::size_t> rows{3, 7, 20, 44, 51, 77, 89};
    std::vector<std::size_t> reported;
    const AOptimalSelection four =
        chooseAOptimal(basis, rows, 4, 8, {}, [&](std::size_t row) { reported.push_back(row); });
    const AOptimalSelection ten = chooseAOptimal(basis, rows, 10, 8);
    QCOMPARE(reported, four.rows);
    QCOMPARE(ten.rows.size(), rows.size());
    QVERIFY(std::ranges::equal(four.rows, std::span(ten.rows).first(4)));
    for (const std::size_t row : ten.rows) QVERIFY(std::ranges::count(rows, row) == 1);
    QVERIFY(std::ranges::is_sorted(ten.residuals, std::greater<>()));
    QVERIFY(chooseAOptimal(basis, {}, 4, 8).rows.empty());
  }

  void hardCase50SameRowsForAnyThreads() {
    const auto basis = randomBasis(500, 40, 12, 6);
    std::vector<std::vector<std::size_t>> found;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      found.push_back(chooseAOptimal(basis, allRows(basis), 15, 12).rows);
    }
    QCOMPARE(found[0], found[1]);
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    const auto basis = randomBasis(90, 30, 8, 7);
    QVERIFY_EXCEPTION_THROWN(chooseAOptimal(basis, allRows(basis), 5, 8, {stop.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(AOptimalSelectionTest)
}  // namespace a_optimal_selection_test

#include "a_optimal_selection_test.moc"
