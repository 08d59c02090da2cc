// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/bounded_least_squares.h"

#include <Eigen/Cholesky>
#include <QTest>
#include <random>

#include "tests/support/test_program.h"

namespace bounded_quadratic_test {
using namespace gonio::fitting;

LinearVector vectorOf(std::initializer_list<double> values) {
  LinearVector v(Eigen::Index(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

struct Problem {
  LinearMatrix n;
  LinearVector b, lower, upper;

  LinearVector solve() const { return solveBounded(n, b, lower, upper); }
  double value(const LinearVector& x) const { return 0.5 * x.dot(n * x) - b.dot(x); }
};

/// Least squares with columns of very different lengths; the bounds cut about every second variable.
Problem randomProblem(std::mt19937& random, int count, int rows, bool isSigned, double decades) {
  std::normal_distribution<double> normal;
  LinearMatrix a(rows, count);
  LinearVector y(rows);
  for (double& x : a.reshaped()) x = normal(random);
  for (double& x : y) x = normal(random);
  Problem problem;
  problem.lower = problem.upper = LinearVector::Zero(count);
  for (int j = 0; j < count; ++j) {
    const double size = std::pow(10.0, decades * j / count);
    a.col(j) *= size;
    problem.upper[j] = 0.3 / size;
    if (isSigned) problem.lower[j] = -0.2 / size;
  }
  problem.n = a.transpose() * a;
  problem.b = a.transpose() * y;
  return problem;
}

/// The value at the best of all 3^n active sets, each solved by its own.
double bruteForce(const Problem& p) {
  const int count = int(p.b.size());
  double best = 0;
  for (int code = 0, end = int(std::pow(3, count) + 0.5); code < end; ++code) {
    LinearVector x = LinearVector::Zero(count);
    std::vector<int> free;
    for (int j = 0, rest = code; j < count; ++j, rest /= 3) {
      if (rest % 3 == 0)
        free.push_back(j);
      else
        x[j] = rest % 3 == 1 ? p.lower[j] : p.upper[j];
    }
    if (!free.empty()) {
      const LinearVector right = p.b(free) - p.n(free, Eigen::all) * x;
      const LinearVector solution = LinearMatrix(p.n(free, free)).llt().solve(right);
      x(free) = solution;
    }
    if ((x.array() < p.lower.array() - 1e-15).any() || (x.array() > p.upper.array() + 1e-15).any()) continue;
    best = std::min(best, p.value(x));
  }
  return best;
}

class BoundedQuadraticTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void agreesWithBruteForce() {
    std::mt19937 random(7);
    for (int trial = 0; trial < 200; ++trial) {
      const Problem problem = randomProblem(random, 1 + trial % 8, 12, trial % 2 == 0, trial % 3 == 0 ? 6 : 0);
      const double found = problem.value(problem.solve()), best = bruteForce(problem);
      QVERIFY2(found <= best + 1e-9 * std::abs(best), qPrintable(QString("%1 %2").arg(found).arg(best)));
    }
  }

  /// Karush, Kuhn and Tucker: inside the gradient is 0, at the lower bound it is >= 0, at the upper one <= 0.
  void optimalForManyVariables() {
    std::mt19937 random(5);
    int atBounds = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const int count = 1 + trial % 40;
      const Problem p = randomProblem(random, count, 60, trial % 2 == 0, trial % 3 == 0 ? 9 : 0);
      const LinearVector x = p.solve(), gradient = p.n * x - p.b;
      for (int j = 0; j < count; ++j) {
        const double tolerance = 1e-8 * std::sqrt(p.n(j, j));
        QVERIFY(x[j] >= p.lower[j] && x[j] <= p.upper[j]);
        if (x[j] < p.upper[j]) QVERIFY(gradient[j] >= -tolerance);
        if (x[j] > p.lower[j]) QVERIFY(gradient[j] <= tolerance);
        atBounds += x[j] == p.lower[j] || x[j] == p.upper[j];
      }
    }
    QVERIFY(atBounds > 500);
  }

  void unseenParameterBecomesZero() {
    for (const int count : {2, 6}) {
      LinearMatrix n = LinearMatrix::Zero(count, count);
      n(0, 0) = 4;
      LinearVector b = LinearVector::Zero(count);
      b[0] = 2;
      const LinearVector x = solveBounded(n, b, LinearVector::Constant(count, -10), LinearVector::Constant(count, 10));
      QCOMPARE(x[0], 0.5);
      for (int j = 1; j < count; ++j) QCOMPARE(x[j], 0.0);
    }
  }

  /// Equal columns: any split is a solution, and one must come out.
  void collinearColumns() {
    for (const int count : {2, 6}) {
      const LinearVector x = solveBounded(LinearMatrix::Ones(count, count), LinearVector::Constant(count, 3),
                                          LinearVector::Zero(count), LinearVector::Constant(count, 10));
      QVERIFY(std::abs(x.sum() - 3) < 1e-12);
      QVERIFY((x.array() >= 0).all());
    }
  }

  void boundsAreMetExactly() {
    const LinearMatrix n = LinearMatrix::Identity(2, 2) * 9;
    const LinearVector x = solveBounded(n, vectorOf({-9, 9}), vectorOf({-0.1, 0}), vectorOf({1, 0.7}));
    QCOMPARE(x[0], -0.1);
    QCOMPARE(x[1], 0.7);
  }
};

GONIO_TEST(BoundedQuadraticTest)
}  // namespace bounded_quadratic_test

#include "bounded_quadratic_test.moc"
