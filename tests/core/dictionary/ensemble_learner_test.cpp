// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/training.h"

#include <QTest>
#include <algorithm>
#include <functional>
#include <numeric>

#include "core/math/parallel.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace ensemble_learner_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr Sizes sizes{8, 6, 7};

void verifyOrthonormal(const std::vector<ModeMatrices<double>>& dictionaries) {
  for (const auto& dictionary : dictionaries)
    for (const Eigen::MatrixXd& mode : dictionary) QVERIFY(orthonormalityError(mode) < 1e-10);
}

/// Without loss, each of one part.
std::vector<EnsembleLearner::Signal> compactSignals(const Eigen::MatrixXd& signals) {
  std::vector<EnsembleLearner::Signal> compact;
  for (Eigen::Index s = 0; s < signals.cols(); ++s)
    compact.push_back({compactSignal<double>(signals.col(s).data(), sizes, 0)});
  return compact;
}

class EnsembleLearnerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The error is that of a reconstruction, and it never grows.
  void errorIsTrueAndFalls() {
    std::mt19937_64 random(1);
    const Matrix<double> signals = Matrix<double>::Random(Eigen::Index(count(sizes)), 30);
    const auto compact = compactSignals(signals);
    EnsembleLearner learner(compact, sizes, 3, 20);
    learner.start(7);
    double before = 1;
    for (int round = 0; round < 12; ++round) {
      const double error = learner.iterate({}, 1 + round % 3);
      QVERIFY2(error <= before * (1 + 1e-9), qPrintable(QString::number(round)));
      before = error;
      verifyOrthonormal(learner.dictionaries());
    }
    // By brute force: project, keep, compose, subtract.
    const double error = learner.assign();
    double left = 0;
    for (int s = 0; s < signals.cols(); ++s) {
      const auto& matrices = learner.dictionaries()[std::size_t(learner.memberships()[std::size_t(s)])];
      Tensor projection = tensorOf(signals.col(s).data(), sizes);
      for (int mode = 0; mode < 3; ++mode)
        projection = transposedModeProduct(projection, matrices[std::size_t(mode)], mode);
      std::vector<double> magnitudes;
      for (std::size_t i = 0; i < projection.count(); ++i) magnitudes.push_back(std::abs(projection[i]));
      std::nth_element(magnitudes.begin(), magnitudes.begin() + 19, magnitudes.end(), std::greater<>());
      for (std::size_t i = 0; i < projection.count(); ++i)
        if (std::abs(projection[i]) < magnitudes[19]) projection[i] = 0;
      const Tensor decoded = composed(projection, matrices);
      left += (Eigen::Map<const Eigen::VectorXd>(decoded.data(), signals.rows()) - signals.col(s)).squaredNorm();
    }
    QVERIFY(std::abs(error - left / signals.squaredNorm()) < 1e-12);
  }

  /// Passes with kept memberships are rounds without the choice: with one dictionary there is none.
  void passesAreRoundsOfTheirOwn() {
    const Matrix<double> signals = Matrix<double>::Random(Eigen::Index(count(sizes)), 12);
    const auto compact = compactSignals(signals);
    EnsembleLearner rounds(compact, sizes, 1, 20), passes(compact, sizes, 1, 20);
    rounds.start(7);
    passes.start(7);
    for (int round = 0; round < 3; ++round) rounds.iterate();
    passes.iterate({}, 3);
    for (std::size_t mode = 0; mode < 3; ++mode)
      QVERIFY(rounds.dictionaries()[0][mode] == passes.dictionaries()[0][mode]);
  }

  /// From the start of every training, the higher-order SVD of random halves, the dictionaries that made the signals
  /// are found again: nothing is left over, signals of one dictionary stay together, and each atom of each mode is one
  /// of the planted atoms up to its sign. (The order of dictionaries and atoms is free.)
  void findsAPlantedDictionary_data() {
    QTest::addColumn<int>("seed");
    for (const int seed : {1, 2, 3}) QTest::addRow("%d", seed) << seed;
  }
  void findsAPlantedDictionary() {
    QFETCH(int, seed);
    std::mt19937_64 random(std::uint64_t(100 + seed));
    const std::vector<ModeMatrices<double>> planted{randomDictionary(sizes, random), randomDictionary(sizes, random)};
    const Matrix<double> signals = plantedSignals(sizes, planted, 3, 120, random);
    const auto compact = compactSignals(signals);
    EnsembleLearner learner(compact, sizes, 2, 3);
    learner.start(std::uint64_t(seed));
    QVERIFY(learner.assign() > 0.5);  // far from the answer
    double error = 1;
    for (int round = 0; round < 100 && error > 1e-14; ++round) error = learner.iterate({}, 4);
    QVERIFY2(error < 1e-12, qPrintable(QString::number(error)));
    learner.assign();
    const std::span<const int> memberships = learner.memberships();
    for (std::size_t s = 0; s < memberships.size(); ++s) QCOMPARE(memberships[s], memberships[s % 2]);
    QVERIFY(memberships[0] != memberships[1]);
    for (std::size_t d = 0; d < 2; ++d)
      for (std::size_t mode = 0; mode < 3; ++mode) {
        const Eigen::MatrixXd cosines =
            (learner.dictionaries()[std::size_t(memberships[d])][mode].transpose() * planted[d][mode]).cwiseAbs();
        // An error of 1e-12 of the energy turns an atom by about 1e-6, so its cosine by about 1e-12.
        for (Eigen::Index atom = 0; atom < cosines.cols(); ++atom) {
          QVERIFY(cosines.col(atom).maxCoeff() > 1 - 1e-9);
          QVERIFY(cosines.row(atom).maxCoeff() > 1 - 1e-9);
        }
      }
  }

  /// The two parts of a signal of both orders are represented as its code over the whole circle: by the dictionary with
  /// the least error, and by the largest coefficients over inBothOrders() of it. The parts have half of its energy.
  void partsShareADictionaryAndCoefficients() {
    const Sizes circle{2 * sizes[0], sizes[1], sizes[2]};
    const std::size_t kept = 20;
    std::mt19937_64 random(3);
    const auto planted = plantedSignals(circle, {randomDictionary(circle, random)}, 60, 24, random);
    std::vector<EnsembleLearner::Signal> signals;
    for (Eigen::Index s = 0; s < planted.cols(); ++s) {
      EnsembleLearner::Signal& signal = signals.emplace_back();
      for (const Eigen::ArrayXd& part : partsOfOrders(planted.col(s).array(), circle[0]))
        signal.push_back(compactSignal<double>(part.data(), sizes, 0));
    }
    EnsembleLearner learner(signals, sizes, 3, int(kept));
    learner.start(7);
    double before = 1;
    for (int round = 0; round < 6; ++round) {
      const double error = learner.iterate({}, 2);
      QVERIFY2(error <= before * (1 + 1e-9), qPrintable(QString::number(round)));
      before = error;
    }
    learner.assign();
    verifyOrthonormal(learner.dictionaries());
    for (Eigen::Index s = 0; s < planted.cols(); ++s) {
      std::vector<double> errors;
      for (const ModeMatrices<double>& modes : learner.dictionaries()) {
        const ModeMatrices<double> both = inBothOrders(Dictionary{modes, 0}).modes;
        Tensor projection = tensorOf(planted.col(s).data(), circle);
        for (int mode = 0; mode < 3; ++mode)
          projection = transposedModeProduct(projection, both[std::size_t(mode)], mode);
        std::vector<double> squares;
        for (std::size_t i = 0; i < projection.count(); ++i) squares.push_back(projection[i] * projection[i]);
        std::ranges::sort(squares, std::greater<>());
        errors.push_back(std::accumulate(squares.begin() + kept, squares.end(), 0.0) / 2);
      }
      const auto smallest = std::ranges::min_element(errors);
      QCOMPARE(learner.memberships()[std::size_t(s)], int(smallest - errors.begin()));
      QVERIFY(std::abs(learner.errors()[std::size_t(s)] - *smallest) < 1e-12 * planted.col(s).squaredNorm());
    }
  }

  /// A second part that is 0, as that of a reciprocal material, changes no bit.
  void aSecondPartOfZerosTeachesNothing() {
    const Eigen::MatrixXd signals = Eigen::MatrixXd::Random(Eigen::Index(count(sizes)), 20);
    const Eigen::VectorXd zeros = Eigen::VectorXd::Zero(signals.rows());
    const auto alone = compactSignals(signals);
    auto padded = alone;
    for (EnsembleLearner::Signal& signal : padded) signal.push_back(compactSignal<double>(zeros.data(), sizes, 0));
    EnsembleLearner expected(alone, sizes, 3, 12), learner(padded, sizes, 3, 12);
    for (EnsembleLearner* one : {&expected, &learner}) {
      one->start(5);
      for (int round = 0; round < 4; ++round) one->iterate({}, 2);
    }
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t mode = 0; mode < 3; ++mode)
        QVERIFY(learner.dictionaries()[d][mode] == expected.dictionaries()[d][mode]);
  }

  /// All coefficients: nothing is left over in any dictionary.
  void hardCase26ExactWithAllCoefficients() {
    const Matrix<double> signals = Matrix<double>::Random(Eigen::Index(count(sizes)), 5);
    const auto compact = compactSignals(signals);
    EnsembleLearner learner(compact, sizes, 2, int(count(sizes)));
    learner.start(1);
    QVERIFY(learner.assign() < 1e-12);
  }

  /// More dictionaries than signals, and one signal alone: empty ones start again from signals, nothing breaks.
  void hardCase28EmptyDictionaries() {
    const Matrix<double> signals = Matrix<double>::Random(Eigen::Index(count(sizes)), 3);
    const auto compact = compactSignals(signals);
    EnsembleLearner learner(compact, sizes, 8, 10);
    learner.start(1);
    double before = 1;
    for (int round = 0; round < 8; ++round) {
      const double error = learner.iterate();
      QVERIFY(error <= before * (1 + 1e-9));
      before = error;
      verifyOrthonormal(learner.dictionaries());
    }
  }

  /// Signals of zeros have no error and disturb nothing; all of them zero is defined.
  void hardCase18SignalsOfZeros() {
    Matrix<double> signals = Matrix<double>::Random(Eigen::Index(count(sizes)), 6);
    signals.col(2).setZero();
    const auto compact = compactSignals(signals);
    EnsembleLearner learner(compact, sizes, 2, 10);
    learner.start(1);
    for (int round = 0; round < 4; ++round) QVERIFY(std::isfinite(learner.iterate()));
    QCOMPARE(learner.errors()[2], 0.0);
    const Matrix<double> zeros = Matrix<double>::Zero(Eigen::Index(count(sizes)), 3);
    const auto compactZeros = compactSignals(zeros);
    EnsembleLearner none(compactZeros, sizes, 2, 10);
    none.start(1);
    for (int round = 0; round < 3; ++round) QCOMPARE(none.iterate(), 0.0);
    verifyOrthonormal(none.dictionaries());
  }

  /// The same bits with one thread and with all.
  void hardCase50SameBitsForAnyThreads() {
    const Eigen::MatrixXd signals = Eigen::MatrixXd::Random(Eigen::Index(count(sizes)), 40);
    std::vector<std::vector<ModeMatrices<double>>> results;
    std::vector<std::vector<int>> memberships;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      const auto compact = compactSignals(signals);
      EnsembleLearner learner(compact, sizes, 3, 12);
      learner.start(5);
      for (int round = 0; round < 6; ++round) learner.iterate({}, 2);
      results.push_back(learner.dictionaries());
      memberships.emplace_back(learner.memberships().begin(), learner.memberships().end());
    }
    QVERIFY(memberships[0] == memberships[1]);
    for (std::size_t d = 0; d < results[0].size(); ++d)
      for (std::size_t mode = 0; mode < 3; ++mode) QVERIFY(results[0][d][mode] == results[1][d][mode]);
  }
};

GONIO_TEST(EnsembleLearnerTest)
}  // namespace ensemble_learner_test

#include "ensemble_learner_test.moc"
