// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/math/matching_pursuit.h"

#include <QTest>
#include <limits>
#include <set>

#include "core/support/error.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/random_matrix.h"
#include "tests/support/test_program.h"

namespace matching_pursuit_test {
using namespace gonio;
using Eigen::MatrixXd, Eigen::VectorXd;
using gonio::test::randomMatrix;

/// Orthonormal columns.
MatrixXd randomBasis(int size, unsigned seed) { return test::orthonormalised(randomMatrix(size, size, seed)); }

VectorXd synthesised(const MatrixXd& atoms, const PursuitResult& code) {
  VectorXd result = VectorXd::Zero(atoms.rows());
  for (std::size_t k = 0; k < code.atoms.size(); ++k) result += code.coefficients[k] * atoms.col(code.atoms[k]);
  return result;
}

MatrixXd chosen(const MatrixXd& atoms, const std::vector<int>& support) {
  MatrixXd result(atoms.rows(), Eigen::Index(support.size()));
  for (std::size_t k = 0; k < support.size(); ++k) result.col(Eigen::Index(k)) = atoms.col(support[k]);
  return result;
}

/// Least squares by a decomposition of its own: what is left of x.
VectorXd leastSquaresResidual(const MatrixXd& columns, const VectorXd& x) {
  if (columns.cols() == 0) return x;
  return x - columns * test::leastSquares(columns, x);
}

std::set<int> asSet(const std::vector<int>& support) { return {support.begin(), support.end()}; }

class MatchingPursuitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every choice and every coefficient by brute force: all atoms tried, least squares anew after each step.
  void orthogonalStepsByBruteForce() {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const MatrixXd atoms = randomMatrix(8, 15, seed);
      const VectorXd signal = randomMatrix(8, 1, 100 + seed);
      const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 6});
      QCOMPARE(code.atoms.size(), std::size_t(6));
      std::vector<int> support;
      VectorXd residual = signal;
      for (const int atom : code.atoms) {
        int best = -1;
        double bestCosine = 0;
        for (int j = 0; j < 15; ++j) {
          const double cosine = std::abs(atoms.col(j).normalized().dot(residual));
          if (asSet(support).contains(j) || cosine <= bestCosine) continue;
          bestCosine = cosine;
          best = j;
        }
        QCOMPARE(atom, best);
        support.push_back(best);
        residual = leastSquaresResidual(chosen(atoms, support), signal);
      }
      QVERIFY(std::abs(code.residualNorm - residual.norm()) < 1e-12);
      QVERIFY((synthesised(atoms, code) - (signal - residual)).norm() < 1e-12 * signal.norm());
    }
  }

  /// In an orthonormal basis the largest coefficients are the best sparse code: all supports are tried.
  void bestSubsetOfAnOrthonormalBasis() {
    const MatrixXd basis = randomBasis(7, 3);
    const VectorXd signal = randomMatrix(7, 1, 4);
    const PursuitResult code = orthogonalMatchingPursuit(AtomSet(basis), signal, {.steps = 3});
    double best = signal.norm();
    for (int i = 0; i < 7; ++i)
      for (int j = i + 1; j < 7; ++j)
        for (int k = j + 1; k < 7; ++k)
          best = std::min(best, leastSquaresResidual(chosen(basis, {i, j, k}), signal).norm());
    QVERIFY(std::abs(code.residualNorm - best) < 1e-13);
  }

  /// Atoms with inner products of at most mu: any signal of fewer than (1 + 1 / mu) / 2 of them is found (Tropp 2004).
  void plantedSupportIsRecovered() {
    // The unit vectors and a Hadamard basis of 16: mu = 1/4, so two atoms are found for certain.
    MatrixXd atoms(16, 32);
    for (int i = 0; i < 16; ++i)
      for (int j = 0; j < 16; ++j) {
        atoms(i, j) = i == j;
        atoms(i, 16 + j) = (__builtin_popcount(unsigned(i & j)) % 2 ? -0.25 : 0.25);
      }
    for (int i = 0; i < 32; ++i)
      for (int j = i + 1; j < 32; ++j) {
        const VectorXd signal = 3 * atoms.col(i) - 0.7 * atoms.col(j);
        const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 5});
        QVERIFY(asSet(code.atoms) == (std::set{i, j}));
        QCOMPARE(code.end, PursuitEnd::residual);
        QVERIFY((synthesised(atoms, code) - signal).norm() < 1e-14);
      }
  }

  /// The atoms' lengths change neither the choice nor what is synthesised.
  void lengthsOfTheAtomsDoNotMatter() {
    const MatrixXd atoms = randomMatrix(6, 10, 5);
    const VectorXd signal = randomMatrix(6, 1, 6), lengths = randomMatrix(10, 1, 7).array().exp() * 1e3;
    const MatrixXd scaled = atoms * lengths.asDiagonal();
    const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 4});
    const PursuitResult other = orthogonalMatchingPursuit(AtomSet(scaled), signal, {.steps = 4});
    QVERIFY(code.atoms == other.atoms);
    QVERIFY((synthesised(atoms, code) - synthesised(scaled, other)).norm() < 1e-12);
  }

  void stops() {
    const MatrixXd atoms = randomMatrix(10, 20, 10);
    const VectorXd signal = randomMatrix(10, 1, 11);
    const PursuitResult all = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 10});
    double before = signal.norm();
    for (int steps = 0; steps < 10; ++steps) {
      const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = steps});
      QCOMPARE(code.end, PursuitEnd::steps);
      QVERIFY(std::equal(code.atoms.begin(), code.atoms.end(), all.atoms.begin()));
      QCOMPARE(code.atoms.size(), std::size_t(steps));
      QVERIFY(steps == 0 || code.residualNorm < before);
      before = code.residualNorm;
    }
    // A fraction of the norm: as few atoms as reach it.
    const PursuitResult half = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 10, .residual = 0.5});
    QCOMPARE(half.end, PursuitEnd::residual);
    QVERIFY(half.residualNorm <= 0.5 * signal.norm());
    const PursuitResult fewer =
        orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = int(half.atoms.size()) - 1});
    QVERIFY(fewer.residualNorm > 0.5 * signal.norm());
  }

  void hardCase21ZeroAtomsAreNeverChosen() {
    MatrixXd atoms = randomMatrix(6, 8, 12);
    atoms.col(0).setZero();
    atoms.col(5).setConstant(1e-320);
    const VectorXd signal = randomMatrix(6, 1, 13);
    const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 100});
    QVERIFY(!asSet(code.atoms).contains(0) && !asSet(code.atoms).contains(5));
    QVERIFY(code.residualNorm < 0.9 * signal.norm());
    // Nothing but zeros: no atom, no NaN.
    const PursuitResult none = orthogonalMatchingPursuit(AtomSet(MatrixXd::Zero(6, 3)), signal, {.steps = 3});
    QVERIFY(none.atoms.empty());
    QCOMPARE(none.end, PursuitEnd::exhausted);
    QCOMPARE(none.residualNorm, signal.norm());
  }

  /// The same atoms, coefficients and residuals as signal by signal, also over atoms that nearly depend on each other:
  /// half of them lie within 0.1 % of sums of two others.
  void manySignalsByTheGramMatrix() {
    MatrixXd atoms(40, 120);
    atoms.leftCols(60) = randomMatrix(40, 60, 31);
    for (Eigen::Index k = 0; k < 60; ++k)
      atoms.col(60 + k) = atoms.col(k) + atoms.col((k + 7) % 60) + 1e-3 * randomMatrix(40, 1, 40 + unsigned(k));
    const AtomSet set(atoms);
    const MatrixXd signals = randomMatrix(40, 25, 32);
    const std::vector<double> residuals(20, 0.01);
    const auto codes = BatchPursuit(set).code(signals, 5, 25, {.steps = 30}, residuals);
    QCOMPARE(codes.size(), std::size_t(20));
    for (Eigen::Index s = 0; s < 20; ++s) {
      const PursuitResult expected =
          orthogonalMatchingPursuit(set, signals.col(5 + s), {.steps = 30, .residual = 0.01});
      const PursuitResult& found = codes[std::size_t(s)];
      QVERIFY(expected.atoms.size() > 10);
      QVERIFY(found.atoms == expected.atoms && found.end == expected.end);
      QVERIFY(std::abs(found.residualNorm - expected.residualNorm) < 1e-12);
      for (std::size_t k = 0; k < found.atoms.size(); ++k)
        QVERIFY(std::abs(found.coefficients[k] - expected.coefficients[k]) < 1e-9);
    }
  }

  void hardCase22RepeatedAndCollinearAtoms() {
    MatrixXd atoms = randomMatrix(6, 4, 14);
    MatrixXd repeated(6, 10);
    repeated << atoms, atoms, -3 * atoms.col(1), atoms.col(0) + atoms.col(2);
    const VectorXd signal = randomMatrix(6, 1, 15);
    const AtomSet set(repeated);
    for (const PursuitResult& code : {orthogonalMatchingPursuit(set, signal, {.steps = 10}),
                                      BatchPursuit(set).code(signal, 0, 1, {.steps = 10}).front()}) {
      QCOMPARE(code.atoms.size(), std::size_t(4));  // what the rank allows
      QCOMPARE(asSet(code.atoms).size(), std::size_t(4));
      QCOMPARE(code.end, PursuitEnd::exhausted);
      const auto singular = test::singularValues(chosen(repeated, code.atoms));
      QVERIFY(singular[3] > 1e-6 * singular[0]);
      QVERIFY(std::abs(code.residualNorm - leastSquaresResidual(atoms, signal).norm()) < 1e-13);
    }
  }

  /// An atom that differs from another by 1e-9 of its length would explain the rest, with coefficients of 1e9.
  void hardCase22NearlyCollinearAtoms() {
    const MatrixXd basis = randomBasis(6, 21);
    MatrixXd atoms(6, 3);
    atoms << basis.col(0), basis.col(0) + 1e-9 * basis.col(1), basis.col(2);
    const VectorXd signal = basis.col(0) + 0.5 * basis.col(1) + 0.1 * basis.col(2);
    const PursuitResult code = orthogonalMatchingPursuit(AtomSet(atoms), signal, {.steps = 6});
    QCOMPARE(code.atoms.size(), std::size_t(2));
    QVERIFY(asSet(code.atoms).contains(2));
    QCOMPARE(code.end, PursuitEnd::exhausted);
    QVERIFY(std::abs(code.residualNorm - 0.5) < 1e-8);
    for (const double coefficient : code.coefficients) QVERIFY(std::abs(coefficient) < 2);
  }

  void hardCase23MoreStepsThanNeeded() {
    const MatrixXd atoms = randomMatrix(5, 12, 16);
    // A signal of 0, and a multiple of one atom.
    const PursuitResult zero = orthogonalMatchingPursuit(AtomSet(atoms), VectorXd::Zero(5), {.steps = 4});
    QVERIFY(zero.atoms.empty() && zero.coefficients.empty());
    QCOMPARE(zero.end, PursuitEnd::residual);
    const PursuitResult one = orthogonalMatchingPursuit(AtomSet(atoms), -2.5 * atoms.col(7), {.steps = 4});
    QVERIFY(one.atoms == std::vector{7});
    QVERIFY(std::abs(one.coefficients[0] + 2.5) < 1e-14);
    QCOMPARE(one.end, PursuitEnd::residual);
    const PursuitResult all =
        orthogonalMatchingPursuit(AtomSet(atoms), randomMatrix(5, 1, 17), {.steps = 12, .residual = 0});
    QVERIFY(all.atoms.size() <= 5);
    QVERIFY(all.residualNorm < 1e-13);
  }

  void hardCase27LowestIndexAmongEqualAtoms() {
    MatrixXd atoms(4, 6);
    atoms << randomMatrix(4, 3, 18), randomMatrix(4, 3, 18);
    atoms.col(4) *= -1;
    for (const int atom : orthogonalMatchingPursuit(AtomSet(atoms), randomMatrix(4, 1, 19), {.steps = 3}).atoms)
      QVERIFY(atom < 3);
  }

  void hardCase42NonFiniteInput() {
    MatrixXd atoms = randomMatrix(4, 3, 20);
    const AtomSet fine(atoms);
    VectorXd signal = VectorXd::Ones(4);
    signal[2] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY_EXCEPTION_THROWN(orthogonalMatchingPursuit(fine, signal, {.steps = 1}), Error);
    QVERIFY_EXCEPTION_THROWN(orthogonalMatchingPursuit(fine, VectorXd::Ones(5), {.steps = 1}), Error);
    atoms(1, 2) = std::numeric_limits<double>::infinity();
    try {
      const AtomSet bad(atoms);
      QFAIL("took an infinite atom");
    } catch (const Error& error) {
      QVERIFY(QString(error.what()).contains("atom 2"));
    }
  }
};

GONIO_TEST(MatchingPursuitTest)
}  // namespace matching_pursuit_test

#include "matching_pursuit_test.moc"
