// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_brdf.h"

#include <QTest>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/random_directions.h"

using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test;

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

QTEST_GUILESS_MAIN(CodeBrdfTest)
#include "code_brdf_test.moc"
