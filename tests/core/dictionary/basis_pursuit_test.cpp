// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/basis_pursuit.h"

#include <Eigen/QR>
#include <QTest>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "tests/core/dictionary/code_test_support.h"
#include "tests/support/test_program.h"

namespace basis_pursuit_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr Sizes sizes{7, 6, 5};

/// A problem with dense matrices, small enough for brute force. A third of the cells is invalid.
struct Problem {
  explicit Problem(bool complete = false) {
    std::mt19937_64 random(5);
    const ModeMatrices<double> modes = randomDictionary(sizes, random);
    const auto cells = Eigen::Index(count(sizes));
    atoms.resize(cells, cells);
    for (Eigen::Index atom = 0; atom < cells; ++atom)
      compose<double>(modes, {{std::uint32_t(atom), 1.0}}, atoms.col(atom).data());
    for (std::size_t mode = 0; mode < 3; ++mode) matrices[mode] = modes[mode].cast<float>();
    valid.assign(std::size_t(cells), 1);
    if (!complete)
      for (std::size_t cell = 0; cell < valid.size(); ++cell) valid[cell] = cell % 3 != 2 || cell < 60;
    signal = Eigen::ArrayXf::Random(cells);
  }

  InvalidCellRefinement<float> rounds() { return {signal, valid, sizes, matrices}; }
  /// atoms^T M (signal - atoms code), M 0 in invalid cells.
  Eigen::VectorXd correlations(const std::vector<Coefficient<float>>& code) const {
    Eigen::VectorXd left = signal.matrix().cast<double>();
    for (const auto& c : code) left -= double(c.value) * atoms.col(c.index);
    for (std::size_t cell = 0; cell < valid.size(); ++cell)
      if (valid[cell] == 0) left[Eigen::Index(cell)] = 0;
    return atoms.transpose() * left;
  }

  ModeMatrices<float> matrices;
  Eigen::MatrixXd atoms;  ///< one per column
  std::vector<std::uint8_t> valid;
  Eigen::ArrayXf signal;
};

class BasisPursuitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// At the minimum of a convex problem with an l1 norm, an atom that is used has the correlation lambda, with the sign
  /// of its coefficient, and no other atom has a larger one.
  void optimalityConditionsHold() {
    Problem problem;
    InvalidCellRefinement<float> rounds = problem.rounds();
    std::vector<Coefficient<float>> code;
    const double lambda = double(pursueBasis(rounds, 20, 3000, code));
    QCOMPARE(code.size(), std::size_t(20));
    QVERIFY(lambda > 0.05);
    Eigen::VectorXd correlations = problem.correlations(code);
    for (const auto& c : code) {
      QVERIFY(std::abs(correlations[c.index] - std::copysign(lambda, double(c.value))) < 1e-4);
      correlations[c.index] = 0;
    }
    QVERIFY(correlations.cwiseAbs().maxCoeff() < lambda + 1e-4);
  }

  /// The refitted values are the least-squares solution over the valid cells, by a dense decomposition.
  void refitIsLeastSquares() {
    Problem problem;
    InvalidCellRefinement<float> rounds = problem.rounds();
    std::vector<Coefficient<float>> code;
    pursueBasis(rounds, 20, 30, code);
    refitValues(rounds, 400, code);
    Eigen::MatrixXd system(Eigen::Index(problem.valid.size()), Eigen::Index(code.size()));
    Eigen::VectorXd values = problem.signal.matrix().cast<double>();
    for (std::size_t i = 0; i < code.size(); ++i) system.col(Eigen::Index(i)) = problem.atoms.col(code[i].index);
    for (std::size_t cell = 0; cell < problem.valid.size(); ++cell)
      if (problem.valid[cell] == 0) system.row(Eigen::Index(cell)).setZero(), values[Eigen::Index(cell)] = 0;
    const Eigen::VectorXd expected = system.colPivHouseholderQr().solve(values);
    for (std::size_t i = 0; i < code.size(); ++i)
      QVERIFY(std::abs(double(code[i].value) - expected[Eigen::Index(i)]) < 1e-4);
  }

  /// Without invalid cells both methods select the same atoms, and the refit gives back their projections.
  void completeSignalsGiveTheLargestProjections() {
    Problem problem(true);
    InvalidCellRefinement<float> rounds = problem.rounds();
    std::vector<Coefficient<float>> code, largest;
    pursueBasis(rounds, 15, 5, code);
    refitValues(rounds, 5, code);
    rounds.selectLargest(15, largest);
    std::ranges::sort(largest, {}, &Coefficient<float>::index);
    QCOMPARE(code.size(), largest.size());
    for (std::size_t i = 0; i < code.size(); ++i) {
      QCOMPARE(code[i].index, largest[i].index);
      QVERIFY(std::abs(code[i].value - largest[i].value) < 1e-5f);
    }
  }

  void softThresholdMovesTowardZero() {
    std::vector<Coefficient<float>> code{{0, -5}, {1, 2}, {2, 3}, {3, -2}};
    QCOMPARE(softThreshold(code, 2), 2.0f);
    QCOMPARE(code.size(), std::size_t(2));
    QCOMPARE(code[0].value, -3.0f);
    QCOMPARE(code[1].value, 1.0f);
    // Equal values leave nothing; with enough room nothing is subtracted; zero coefficients are black.
    code = {{0, 1}, {1, -1}};
    QCOMPARE(softThreshold(code, 1), 1.0f);
    QVERIFY(code.empty());
    code = {{0, 1}};
    QCOMPARE(softThreshold(code, 1), 0.0f);
    QCOMPARE(code[0].value, 1.0f);
    QCOMPARE(softThreshold(code, 0), 1.0f);
    QVERIFY(code.empty());
  }

  /// Through the encoder: a planted code over the valid cells is found; the same bits with any dictionary chosen alike.
  void encoderUsesTheMethod() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(3).load(1);
    EncodeOptions options{.coefficients = 60, .transforms = {DataTransform::logPlus}};
    const EncodeResult greedy = Encoder(ensemble).encode(*table, options);
    options.method = CodingMethod::basisPursuit;
    const EncodeResult convex = Encoder(ensemble).encode(*table, options);
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(convex.code.channels[c].dictionary, greedy.code.channels[c].dictionary);
      QVERIFY(convex.code.channels[c].coefficients.size() <= 60);
    }
    QVERIFY(!sameBits(convex.code, greedy.code));
    // Both represent the same table about equally well.
    QVERIFY(relativeDifference(*table, *decode(ensemble, convex.code)) <
            1.5 * relativeDifference(*table, *decode(ensemble, greedy.code)));
    // All coefficients: exact.
    options.coefficients = smallGrid.size();
    QVERIFY(relativeDifference(*table, *decode(ensemble, Encoder(ensemble).encode(*table, options).code)) < 1e-5);
    options.coefficients = 0;
    QCOMPARE(Encoder(ensemble).encode(*table, options).code.coefficients(), std::size_t(0));
  }

  void canBeCancelled() {
    Problem problem;
    InvalidCellRefinement<float> rounds = problem.rounds();
    std::vector<Coefficient<float>> code;
    std::stop_source source;
    source.request_stop();
    const TaskControl stopped{.stop = source.get_token(), .progress = {}};
    QVERIFY_EXCEPTION_THROWN(pursueBasis(rounds, 5, 3, code, stopped), Cancelled);
    QVERIFY_EXCEPTION_THROWN(refitValues(rounds, 3, code, stopped), Cancelled);
  }
};

GONIO_TEST(BasisPursuitTest)
}  // namespace basis_pursuit_test

#include "basis_pursuit_test.moc"
