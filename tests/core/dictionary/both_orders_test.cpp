// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/dictionary/code_interpolation.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "tests/core/dictionary/code_test_support.h"
#include "tests/support/random_directions.h"
#include "tests/support/test_program.h"

namespace both_orders_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

const HalfDifferenceGrid circle = smallGrid.wholeCircle();

double largestDifference(const TabulatedBrdf& a, const TabulatedBrdf& b) {
  double largest = 0;
  for (std::size_t cell = 0; cell < a.values().size(); ++cell)
    if (a.valid()[cell] != 0)
      for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(double(a.values()[cell][c]) - double(b.values()[cell][c])));
  return largest;
}

class BothOrdersTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    ensemble_ = randomEnsemble(2);
    table_ = oneWayTable();
  }

  void theDictionariesAreOrthonormal() {
    const Ensemble both = inBothOrders(ensemble_);
    QCOMPARE(both.grid, circle);
    QVERIFY(orthonormalityError(both) < 1e-12);
    QVERIFY(inBothOrders(both).dictionaries[1].modes[0] == both.dictionaries[1].modes[0]);
  }

  /// With all coefficients a code is the table: both orders, negative values among them.
  void allCoefficientsRestoreTheTable() {
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      const SparseCode code =
          Encoder(ensemble_)
              .encode(*table_, {.coefficients = circle.size(), .transforms = {transform}, .refinements = 0})
              .code;
      QVERIFY(code.hasBothOrders());
      QVERIFY(code.channels[0].lowest < 0 && code.channels[1].lowest == 0);
      const auto decoded = decode(ensemble_, code);
      QVERIFY(largestDifference(*table_, *decoded) < 2e-4);
      const auto darkest = std::ranges::min_element(decoded->values(), {}, [](const glm::vec3& v) { return v.r; });
      QVERIFY(darkest->r < -0.1f);
      // Between the nodes the code is its table.
      const auto brdf = makeCodeBrdf(ensemble_, code);
      QVERIFY(!brdf->isReciprocal());
      std::mt19937_64 random(5);
      for (int i = 0; i < 500; ++i) {
        const DirectionPair pair{test::randomUpper(random), test::randomUpper(random)};
        const Rgb value = brdf->evaluate(pair.wi, pair.wo), expected = decoded->evaluate(pair.wi, pair.wo);
        for (int c = 0; c < 3; ++c) QVERIFY(std::abs(value[c] - expected[c]) < 1e-4 * (1 + std::abs(expected[c])));
      }
    }
  }

  /// A few coefficients go to the part that has the more energy: the error is that of the largest of both.
  void theLargestCoefficientsOfBothParts() {
    const auto encoded = [&](std::size_t count) {
      return Encoder(ensemble_)
          .encode(*table_, {.coefficients = count, .transforms = {DataTransform::logPlus}, .refinements = 0})
          .code;
    };
    const SparseCode few = encoded(100), all = encoded(circle.size());
    bool hasOdd = false, hasEven = false;
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(few.channels[c].coefficients.size(), std::size_t(100));
      const auto& larger = all.channels[c].coefficients;
      if (few.channels[c].dictionary != all.channels[c].dictionary) continue;
      for (std::size_t i = 0; i < 100; ++i)
        QVERIFY(std::abs(std::abs(few.channels[c].coefficients[i].value) - std::abs(larger[i].value)) < 1e-5f);
      for (const Coefficient<float>& coefficient : few.channels[c].coefficients)
        (coefficient.index % 2 == 1 ? hasOdd : hasEven) = true;
    }
    QVERIFY(hasOdd && hasEven);
  }

  /// The code of a reciprocal material has the same values in both orders.
  void aReciprocalCodeOverTheWholeCircle() {
    const SparseCode half = Encoder(ensemble_).encode(*ggxMaterials(1).load(0), {.coefficients = 60}).code;
    QVERIFY(!half.hasBothOrders());
    const SparseCode whole = inBothOrders(half);
    const auto expected = decode(ensemble_, half), found = decode(ensemble_, whole);
    QCOMPARE(found->grid(), circle);
    const auto count = std::size_t(smallGrid.phiDCount);
    for (std::size_t cell = 0; cell < found->values().size(); ++cell) {
      const std::size_t folded = cell / (2 * count) * count + cell % count;
      QCOMPARE(found->valid()[cell], expected->valid()[folded]);
      for (int c = 0; c < 3; ++c) {
        const double value = expected->values()[folded][c];
        QVERIFY(std::abs(double(found->values()[cell][c]) - value) < 1e-4 * (1 + value));
      }
    }
  }

  void packedAndUnpacked() {
    const SparseCode code = Encoder(ensemble_).encode(*table_, {.coefficients = 80, .quantised = true}).code;
    for (const CodePrecision precision : {CodePrecision::single, CodePrecision::quantised}) {
      SparseCode read = code;
      const auto bytes = packChannels(code, precision);
      for (ChannelCode& channel : read.channels) channel = {};
      unpackChannels(bytes, precision, read);
      QVERIFY(sameBits(read, code));
      for (std::size_t c = 0; c < 3; ++c) QCOMPARE(read.channels[c].lowest, code.channels[c].lowest);
      QVERIFY_EXCEPTION_THROWN(unpackChannels(std::span(bytes).first(7), precision, read), Error);
    }
  }

  /// A blend with a reciprocal material has both orders; halfway it is the mean of the transformed values.
  void blendsWithReciprocalCodes() {
    const auto transforms = std::vector{DataTransform::logPlus};
    const EncodeOptions all{.coefficients = circle.size(), .transforms = transforms, .refinements = 0};
    const std::array codes{Encoder(ensemble_).encode(*table_, all).code,
                           Encoder(ensemble_).encode(*ggxMaterials(1).load(0), all).code};
    const SparseCode blend = interpolateCodes(ensemble_, codes, std::array{0.5, 0.5}, circle.size());
    QVERIFY(blend.hasBothOrders());
    const auto first = decodeSignals(ensemble_, codes[0]), second = decodeSignals(ensemble_, inBothOrders(codes[1])),
               found = decodeSignals(ensemble_, blend);
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY((found[c] - (0.5 * first[c] + 0.5 * second[c])).abs().maxCoeff() < 1e-3);
  }

 private:
  Ensemble ensemble_;
  std::shared_ptr<const TabulatedBrdf> table_;
};

GONIO_TEST(BothOrdersTest)
}  // namespace both_orders_test

#include "both_orders_test.moc"
