// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/decode.h"

#include <QTest>
#include <cmath>

#include "core/dictionary/encode.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace code_brdf_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr std::array dataTransforms{DataTransform::logPlus, DataTransform::cosineLog, DataTransform::root,
                                    DataTransform::none};
constexpr float unbounded = ChannelCode{}.highest;

class CodeBrdfTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    ensemble_ = randomEnsemble(2);
    table_ = ggxMaterials(1).load(0);
  }

  /// At the nodes of the grid it is the decoded table, in both transforms.
  void agreesWithTheDecodedTable() {
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      const SparseCode code = Encoder(ensemble_).encode(*table_, {.coefficients = 150, .transforms = {transform}}).code;
      const auto brdf = makeCodeBrdf(ensemble_, code);
      const auto decoded = decode(ensemble_, code);
      std::size_t compared = 0;
      for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
        // Where theta_h or theta_d is 0 the other angles of the node are lost in its directions.
        const HalfDifference node = smallGrid.node(cell);
        if (decoded->valid()[cell] == 0 || node.thetaH == 0 || node.thetaD == 0) continue;
        const DirectionPair pair = smallGrid.directions(cell);
        if (std::min(pair.wi.z, pair.wo.z) < 1e-3) continue;
        const Rgb value = brdf->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c)
          QVERIFY(std::abs(value[c] - double(decoded->values()[cell][c])) < 2e-4 * (1 + value[c]));
        ++compared;
      }
      QVERIFY(compared > 500);
    }
  }

  /// Between the nodes too, behind the last node of each axis, and where some corners are below the horizon.
  void isTheDecodedTable() {
    for (const DataTransform transform : dataTransforms) {
      SparseCode code = Encoder(ensemble_).encode(*table_, {.coefficients = 150, .transforms = {transform}}).code;
      for (ChannelCode& channel : code.channels) channel.highest = unbounded;
      const auto brdf = makeCodeBrdf(ensemble_, code);
      const auto decoded = decode(ensemble_, code);
      std::mt19937_64 random(6);
      std::uniform_real_distribution<double> uniform(0, 1);
      std::array<int, 3> behindLast{};
      int positive = 0;
      for (int i = 0; i < 20000; ++i) {
        const HalfDifference where{uniform(random) * halfPi, uniform(random) * halfPi, uniform(random) * pi};
        if (!isAboveHorizon(where.thetaH, where.thetaD, where.phiD)) continue;
        const auto [wi, wo] = fromHalfDifference(where.thetaH, where.thetaD, where.phiD);
        const auto at = smallGrid.position(where);
        behindLast[0] += at.thetaH > smallGrid.thetaHCount - 1;
        behindLast[1] += at.thetaD > smallGrid.thetaDCount - 1;
        behindLast[2] += at.phiD > smallGrid.phiDCount - 1;
        const Rgb value = brdf->evaluate(wi, wo), expected = decoded->evaluate(wi, wo);
        for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - expected[c]) < 1e-4 * (1 + expected[c]));
        positive += expected.y > 0;
      }
      for (const int count : behindLast) QVERIFY(count > 10);
      QVERIFY(positive > 5000);
    }
  }

  /// Coefficients that share the atoms of one mode and not of the other.
  void groupsOfCoefficients() {
    SparseCode code{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
    const auto index = [](int l0, int l1, int l2) { return std::uint32_t(smallGrid.index(l2, l1, l0)); };
    for (ChannelCode& channel : code.channels)
      channel.coefficients = {{index(2, 3, 1), 5.0f},
                              {index(7, 3, 4), -4.0f},
                              {index(7, 5, 4), 3.0f},
                              {index(9, 5, 4), 2.0f},
                              {index(2, 3, 9), 1.0f}};
    const auto brdf = makeCodeBrdf(ensemble_, code);
    const auto signals = decodeSignals(ensemble_, code);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      const HalfDifference node = smallGrid.node(cell);
      const auto [wi, wo] = smallGrid.directions(cell);
      if (node.thetaH == 0 || node.thetaD == 0 || std::min(wi.z, wo.z) < 1e-3) continue;
      const double expected = std::expm1(std::max(0.0, double(signals[0][Eigen::Index(cell)])));
      QVERIFY(std::abs(brdf->evaluate(wi, wo).x - expected) < 1e-3 * (1 + expected));
    }
  }

  /// Sums of atoms stop at the largest value of the measurement.
  void isBoundedByTheMeasurement() {
    SparseCode code =
        Encoder(ensemble_).encode(*table_, {.coefficients = 40, .transforms = {DataTransform::logPlus}}).code;
    const float bound = code.channels[1].highest / 2;
    code.channels[1].highest = bound;
    const auto brdf = makeCodeBrdf(ensemble_, code);
    std::mt19937_64 random(7);
    double largest = 0;
    for (int i = 0; i < 2000; ++i)
      largest = std::max(largest, brdf->evaluate(test::randomUpper(random), test::randomUpper(random)).y);
    QVERIFY(std::abs(largest / std::expm1(double(bound)) - 1) < 1e-6);
  }

  /// Whatever the atoms are there.
  void hardCase04OppositeDirections() {
    for (const float sign : {1.0f, -1.0f}) {
      SparseCode bright{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
      for (ChannelCode& channel : bright.channels)
        for (std::uint32_t i = 0; i < 200; ++i) channel.coefficients.push_back({i, sign});
      const auto brdf = makeCodeBrdf(ensemble_, bright);
      QCOMPARE(brdf->evaluate(Direction(1, 0, 0), Direction(-1, 0, 0)), Rgb(0));
      QCOMPARE(brdf->evaluate(Direction(0, 0.6, 0.8), Direction(0, -0.6, -0.8)), Rgb(0));
    }
  }

  void foreignCodesAreRefused() {
    SparseCode code{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
    code.channels[0].dictionary = 2;
    QVERIFY_EXCEPTION_THROWN(makeCodeBrdf(ensemble_, code), Error);
    code.channels[0] = {.dictionary = 0, .coefficients = {{std::uint32_t(smallGrid.size()), 1.0f}}};
    QVERIFY_EXCEPTION_THROWN(makeCodeBrdf(ensemble_, code), Error);
    code.channels[0] = {};
    code.grid.thetaHCount += 1;
    QVERIFY_EXCEPTION_THROWN(makeCodeBrdf(ensemble_, code), Error);
  }

  /// Below the horizon nothing; elsewhere finite and not negative; a batch is its pairs.
  void keepsThePromisesOfABrdf() {
    const SparseCode code = Encoder(ensemble_).encode(*table_, {.coefficients = 100}).code;
    const auto brdf = makeCodeBrdf(ensemble_, code);
    QCOMPARE(brdf->evaluate(fromSpherical(1.6, 0), fromSpherical(0.3, 1)), Rgb(0));
    QCOMPARE(brdf->evaluate(fromSpherical(0.3, 0), fromSpherical(1.6, 1)), Rgb(0));
    std::mt19937_64 random(4);
    std::vector<DirectionPair> pairs(1000);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (DirectionPair& pair : pairs)
      pair = {fromSpherical(uniform(random) * halfPi, 6.3 * uniform(random)),
              fromSpherical(uniform(random) * halfPi, 6.3 * uniform(random))};
    pairs[0].wi = pairs[0].wo;
    std::vector<Rgb> values(pairs.size());
    brdf->evaluate(pairs, values);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      QCOMPARE(values[i], brdf->evaluate(pairs[i].wi, pairs[i].wo));
      for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(values[i][c]) && values[i][c] >= 0);
    }
  }

  /// Reciprocal where the table is folded: phi_d is the same for the swapped pair.
  void isReciprocal() {
    const SparseCode code = Encoder(ensemble_).encode(*table_, {.coefficients = 100}).code;
    const auto brdf = makeCodeBrdf(ensemble_, code);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 500; ++i) {
      const Direction a = fromSpherical(1.4 * uniform(random), 6.3 * uniform(random)),
                      b = fromSpherical(1.4 * uniform(random), 6.3 * uniform(random));
      const Rgb ab = brdf->evaluate(a, b), ba = brdf->evaluate(b, a);
      for (int c = 0; c < 3; ++c) QVERIFY(std::abs(ab[c] - ba[c]) < 1e-4 * (1 + ab[c]));
    }
  }

  void ofNoCoefficientsIsBlack() {
    const SparseCode code{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
    QCOMPARE(makeCodeBrdf(ensemble_, code)->evaluate(fromSpherical(0.3, 0), fromSpherical(0.4, 2)), Rgb(0));
  }

 private:
  Ensemble ensemble_;
  std::shared_ptr<const TabulatedBrdf> table_;
};

GONIO_TEST(CodeBrdfTest)
}  // namespace code_brdf_test

#include "code_brdf_test.moc"
