// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/k_svd.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "core/math/matching_pursuit.h"
#include "core/math/parallel.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace k_svd_test {
using namespace gonio;
using namespace gonio::dictionary;
using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd gaussian(int rows, int columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

/// Signals of `sparsity` atoms each, chosen at random.
MatrixXd planted(const MatrixXd& atoms, int sparsity, int signals, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd result = MatrixXd::Zero(atoms.rows(), signals);
  for (auto signal : result.colwise())
    for (int t = 0; t < sparsity; ++t) {
      const double value = normal(random);
      signal += (value + std::copysign(0.5, value)) * atoms.col(Eigen::Index(random() % std::uint64_t(atoms.cols())));
    }
  return result;
}

double squaredError(const MatrixXd& signals, const MatrixXd& atoms, int sparsity) {
  const AtomSet set(atoms);
  double sum = 0;
  for (const auto signal : signals.colwise())
    sum += std::pow(orthogonalMatchingPursuit(set, signal, {.steps = sparsity}).residualNorm, 2);
  return sum / signals.squaredNorm();
}

/// The paper's count: atoms of `truth` with an atom of |cosine| > 0.99.
int foundAtoms(const MatrixXd& atoms, const MatrixXd& truth) {
  return int(((truth.transpose() * atoms).cwiseAbs().rowwise().maxCoeff().array() > 0.99).count());
}

class KSvdTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// A planted dictionary is found again from its sparse combinations alone: the first atoms are signals, which are
  /// none of the planted ones.
  void findsAPlantedDictionary() {
    MatrixXd truth = gaussian(20, 30, 1);
    truth.colwise().normalize();
    const MatrixXd signals = planted(truth, 2, 1500, 2);
    const KSvdOptions options{.atoms = 30, .sparsity = 2, .iterations = 60, .tolerance = 0};
    KSvdOptions begun = options;
    begun.iterations = 1;
    QVERIFY(foundAtoms(learnKSvd(signals, begun).atoms, truth) < 10);
    const KSvdResult result = learnKSvd(signals, options);
    QCOMPARE(foundAtoms(result.atoms, truth), 30);
    QVERIFY(squaredError(signals, result.atoms, 2) < 1e-3);
  }

  /// The experiment of the paper's section V.A without noise: 50 atoms of 20 numbers, 1500 signals of 3 atoms each, 80
  /// iterations. Like the paper's runs, each ends at a local minimum with nearly all atoms; by chance, an atom of 20
  /// numbers is within |cosine| 0.99 of a given one with a probability of about 1e-17.
  void findsNearlyAllAtomsOfThePublishedExperiment() {
    int found = 0;
    for (const unsigned seed : {10u, 20u, 30u}) {
      MatrixXd truth = gaussian(20, 50, seed);
      truth.colwise().normalize();
      const MatrixXd signals = planted(truth, 3, 1500, seed + 1);
      const KSvdResult result = learnKSvd(signals, {.atoms = 50, .sparsity = 3, .iterations = 80, .tolerance = 0});
      found += foundAtoms(result.atoms, truth);
    }
    QVERIFY2(found >= 138, qPrintable(QString::number(found)));  // 92 % of 3 x 50
  }

  /// One atom for all signals is the first principal direction.
  void oneAtomIsTheFirstSingularVector() {
    const MatrixXd signals = gaussian(8, 3, 3) * gaussian(3, 200, 4);
    const KSvdResult result = learnKSvd(signals, {.atoms = 1, .sparsity = 1, .iterations = 200, .tolerance = 0});
    const test::JacobiSvd svd = test::jacobiSvd(signals);
    QVERIFY(std::abs(std::abs(result.atoms.col(0).dot(svd.u.col(0))) - 1) < 1e-9);
    const double first = std::pow(svd.values[0], 2);
    // The error is that of the atom as it has become, also before it is done.
    const KSvdResult begun = learnKSvd(signals, {.atoms = 1, .sparsity = 1, .iterations = 1});
    const double kept = (signals.transpose() * begun.atoms.col(0)).squaredNorm();
    QVERIFY(std::abs(begun.errors[0] - (1 - kept / signals.squaredNorm())) < 1e-12);
    QVERIFY(begun.errors[0] > result.errors.back());
    QVERIFY(std::abs(result.errors.back() - (1 - first / signals.squaredNorm())) < 1e-9);
  }

  /// Where signals use one atom the pursuit is the exact minimiser: no round raises the error.
  void theErrorNeverRisesWithOneAtomASignal() {
    const MatrixXd signals = gaussian(12, 300, 5);
    const KSvdResult result = learnKSvd(signals, {.atoms = 40, .sparsity = 1, .iterations = 40, .tolerance = 0});
    QVERIFY(result.errors.size() > 10);
    for (std::size_t round = 1; round < result.errors.size(); ++round)
      QVERIFY(result.errors[round] <= result.errors[round - 1] * (1 + 1e-12));
  }

  /// With several the best round counts.
  void theAtomsAreThoseOfTheLeastError() {
    const MatrixXd signals = gaussian(12, 300, 5);
    const KSvdResult result = learnKSvd(signals, {.atoms = 40, .sparsity = 3, .iterations = 40, .tolerance = 0});
    const double least = *std::min_element(result.errors.begin(), result.errors.end());
    QVERIFY(least < 0.7 * result.errors.front());
    for (const auto atom : result.atoms.colwise()) QVERIFY(std::abs(atom.norm() - 1) < 1e-12);
    QVERIFY(std::abs(squaredError(signals, result.atoms, 3) / least - 1) < 0.1);
    const auto best = std::size_t(std::min_element(result.errors.begin(), result.errors.end()) - result.errors.begin());
    const KSvdResult again =
        learnKSvd(signals, {.atoms = 40, .sparsity = 3, .iterations = int(best) + 1, .tolerance = 0});
    QVERIFY(again.atoms == result.atoms);
  }

  /// It ends when little is won.
  void endsByItsTolerance() {
    const MatrixXd signals = gaussian(12, 300, 5);
    const KSvdResult result = learnKSvd(signals, {.atoms = 40, .sparsity = 3, .iterations = 500, .tolerance = 1e-2});
    const std::size_t rounds = result.errors.size();
    QVERIFY(rounds > 6 && rounds < 100);
    const auto least = [&](std::size_t count) {
      return *std::min_element(result.errors.begin(), result.errors.begin() + std::ptrdiff_t(count));
    };
    QVERIFY(least(rounds - 5) - least(rounds) <= 1e-2 * least(rounds - 5));
    QVERIFY(least(rounds - 6) - least(rounds - 1) > 1e-2 * least(rounds - 6));
    QVERIFY(result.complete);
  }

  /// Atoms that are one are used by nobody but the first; the others go to the signals that are served worst.
  void equalAndUnusedAtomsAreReplaced() {
    // Nearly all signals lie along one axis, and so do the atoms that are drawn at first.
    MatrixXd signals = MatrixXd::Zero(4, 40);
    for (int s = 0; s < 37; ++s) signals(0, s) = 1 + s;
    for (int axis = 1; axis < 4; ++axis) signals(axis, 36 + axis) = 0.5;
    const KSvdResult result = learnKSvd(signals, {.atoms = 4, .sparsity = 1, .iterations = 20, .tolerance = 0});
    QVERIFY(result.errors.front() > 0);
    QVERIFY(result.errors.back() < 1e-20);
    // One round is enough to have them all: each goes to another signal.
    const KSvdResult once = learnKSvd(signals, {.atoms = 4, .sparsity = 1, .iterations = 1});
    QVERIFY(squaredError(signals, once.atoms, 1) < 1e-20);
  }

  void hardCase50SameBitsForAnyThreads() {
    const MatrixXd signals = gaussian(12, 500, 6);
    std::vector<MatrixXd> atoms;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      atoms.push_back(learnKSvd(signals, {.atoms = 30, .sparsity = 3, .iterations = 5}).atoms);
    }
    QVERIFY(std::memcmp(atoms[0].data(), atoms[1].data(), std::size_t(atoms[0].size()) * sizeof(double)) == 0);
    const KSvdResult other = learnKSvd(signals, {.atoms = 30, .sparsity = 3, .iterations = 5, .seed = 2});
    QVERIFY(other.atoms != atoms[0]);
  }

  /// Signals of 0 are allowed among others, need no atom, and are never drawn as one.
  void hardCase12BlackSignals() {
    MatrixXd signals = gaussian(6, 60, 7);
    signals.rightCols(40).setZero();
    const KSvdResult result = learnKSvd(signals, {.atoms = 20, .sparsity = 2, .iterations = 5});
    QVERIFY(result.atoms.allFinite());
    for (const auto atom : result.atoms.colwise()) QVERIFY(std::abs(atom.norm() - 1) < 1e-12);
    QVERIFY(result.errors.back() < 1e-20);
  }

  void hardCase42ValuesThatAreNone() {
    MatrixXd signals = gaussian(6, 60, 8);
    signals(3, 17) = std::numeric_limits<double>::quiet_NaN();
    try {
      learnKSvd(signals, {.atoms = 5, .sparsity = 2});
      QFAIL("took a NaN");
    } catch (const Error& error) {
      QVERIFY(QString(error.what()).contains("signal 17"));
    }
  }

  void wrongCountsAreTold() {
    const MatrixXd signals = gaussian(6, 10, 9);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(signals, {.atoms = 11, .sparsity = 2}), Error);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(signals, {.atoms = 0, .sparsity = 2}), Error);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(signals, {.atoms = 5, .sparsity = 0}), Error);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(signals, {.atoms = 5, .sparsity = 2, .iterations = 0}), Error);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(MatrixXd::Zero(6, 10), {.atoms = 1, .sparsity = 1}), Error);
  }

  void aStopGivesTheBestSoFar() {
    const MatrixXd signals = gaussian(12, 300, 5);
    std::stop_source stop;
    const TaskControl control{stop.get_token(), [&](double fraction) {
                                if (fraction > 0.11) stop.request_stop();
                              }};
    const KSvdOptions options{.atoms = 40, .sparsity = 3, .iterations = 20, .tolerance = 0};
    const KSvdResult result = learnKSvd(signals, options, control);
    QVERIFY(!result.complete);
    QVERIFY(result.errors.size() >= 1 && result.errors.size() < 20);
    KSvdOptions fewer = options;
    fewer.iterations = int(result.errors.size());
    QVERIFY(learnKSvd(signals, fewer).atoms == result.atoms);
    QVERIFY_EXCEPTION_THROWN(learnKSvd(signals, options, {stop.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(KSvdTest)
}  // namespace k_svd_test

#include "k_svd_test.moc"
