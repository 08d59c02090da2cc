// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/code_interpolation.h"

#include <QTest>
#include <cstring>
#include <limits>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "core/math/parallel.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace code_interpolation_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

SparseCode encoded(const Ensemble& ensemble, std::size_t material, DataTransform transform) {
  return Encoder(ensemble)
      .encode(*ggxMaterials(3).load(material), {.coefficients = 120, .transforms = {transform}})
      .code;
}

class CodeInterpolationTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Coefficients of one dictionary, carried over into another, stand for the same signal: exactly, in double.
  void rotationIsExactForSquareDictionaries() {
    std::mt19937_64 random(1);
    const Sizes sizes = modeSizes(smallGrid);
    const Ensemble ensemble = randomEnsemble(2);
    const auto rotations = rotationsBetween(ensemble.dictionaries[0], ensemble.dictionaries[1]);
    for (std::size_t mode = 0; mode < 3; ++mode) {
      QVERIFY(orthonormalityError(rotations[mode]) < 1e-13);
      QVERIFY((ensemble.dictionaries[0].modes[mode] * rotations[mode] - ensemble.dictionaries[1].modes[mode])
                  .cwiseAbs()
                  .maxCoeff() < 1e-13);
    }
    std::vector<Coefficient<double>> code;
    for (std::uint32_t t = 0; t < 50; ++t) code.push_back({t * 41 % std::uint32_t(count(sizes)), 1.0 + t});
    std::vector<double> direct(count(sizes)), carried(count(sizes)), decoded(count(sizes));
    compose<double>(ensemble.dictionaries[1].modes, code, direct.data());
    compose<double>(rotations, code, carried.data());
    std::vector<Coefficient<double>> all;
    selectLargest(std::span<const double>(carried), count(sizes), all);
    compose<double>(ensemble.dictionaries[0].modes, all, decoded.data());
    for (std::size_t i = 0; i < decoded.size(); ++i) QVERIFY(std::abs(decoded[i] - direct[i]) < 1e-12 * 50);
  }

  /// Interpolated codes decode to the interpolated signals, in one dictionary and across two.
  void isLinearInTheTransformedDomain() {
    const Ensemble ensemble = randomEnsemble(4);
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      std::vector<SparseCode> codes;
      for (const std::size_t m : {0, 1, 2}) codes.push_back(encoded(ensemble, m, transform));
      // One channel in the same dictionary, the others in different ones.
      codes[1].channels[0].dictionary = codes[2].channels[0].dictionary = codes[0].channels[0].dictionary;
      codes[1].channels[1].dictionary = (codes[0].channels[1].dictionary + 1) % 4;
      for (SparseCode& code : codes)
        for (ChannelCode& channel : code.channels) channel.highest = ChannelCode().highest;  // bounds are not linear
      const std::vector<double> weights{0.5, 0.2, 0.3};
      const SparseCode between = interpolateCodes(ensemble, codes, weights, smallGrid.size());
      const auto result = decodeSignals(ensemble, between);
      for (std::size_t c = 0; c < 3; ++c) {
        Eigen::ArrayXd expected = Eigen::ArrayXd::Zero(Eigen::Index(smallGrid.size()));
        for (std::size_t m = 0; m < 3; ++m) expected += weights[m] * decodeSignals(ensemble, codes[m])[c];
        QVERIFY((result[c] - expected).abs().maxCoeff() < 1e-4f);
      }
    }
  }

  void hardCase30WeightsAtTheEndsAndOutside() {
    const Ensemble ensemble = randomEnsemble(3);
    const std::vector<SparseCode> codes{encoded(ensemble, 0, DataTransform::logPlus),
                                        encoded(ensemble, 2, DataTransform::logPlus)};
    for (const std::size_t end : {0, 1}) {
      const std::vector<double> weights{end == 0 ? 1.0 : 0.0, end == 0 ? 0.0 : 1.0};
      const SparseCode result = interpolateCodes(ensemble, codes, weights, 10);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto &a = result.channels[c].coefficients, &b = codes[end].channels[c].coefficients;
        QCOMPARE(result.channels[c].dictionary, codes[end].channels[c].dictionary);
        QCOMPARE(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) QVERIFY(a[i].index == b[i].index && a[i].value == b[i].value);
      }
    }
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const std::vector<double>& weights :
         {std::vector{1.5, -0.5}, {nan, 1.0}, {0.5, 0.4}, {1.0}, {0.2, 0.3, 0.5}, std::vector<double>{}})
      QVERIFY_EXCEPTION_THROWN(interpolateCodes(ensemble, codes, weights, 10), Error);
  }

  void hardCase31MixedTransformsAreRefused() {
    const Ensemble ensemble = randomEnsemble(2);
    const std::vector<SparseCode> codes{encoded(ensemble, 0, DataTransform::logPlus),
                                        encoded(ensemble, 2, DataTransform::cosineLog)};
    QVERIFY_EXCEPTION_THROWN(interpolateCodes(ensemble, codes, std::vector{0.5, 0.5}, 10), Error);
  }

  /// Of dictionaries that lack atoms the product is no rotation; its polar factor is.
  void hardCase30TruncatedDictionaries() {
    Ensemble ensemble = randomEnsemble(2);
    for (Dictionary& dictionary : ensemble.dictionaries)
      for (Eigen::MatrixXd& mode : dictionary.modes) mode = mode.leftCols(5).eval();
    const auto rotations = rotationsBetween(ensemble.dictionaries[0], ensemble.dictionaries[1]);
    for (std::size_t mode = 0; mode < 3; ++mode) {
      const Eigen::MatrixXd product =
          ensemble.dictionaries[0].modes[mode].transpose() * ensemble.dictionaries[1].modes[mode];
      QVERIFY(orthonormalityError(product) > 0.1);
      QVERIFY(orthonormalityError(rotations[mode]) < 1e-12);
      // Of all rotations it is the nearest to the product.
      std::mt19937_64 random(3);
      const double distance = (rotations[mode] - product).norm();
      for (int i = 0; i < 20; ++i) QVERIFY((randomOrthonormal(5, random) - product).norm() > distance);
    }
  }

  /// A material without a weight leaves no trace, no coefficient is 0, and the order of a sum does not matter.
  void materialsWithoutWeightAddNothing() {
    const Ensemble ensemble = randomEnsemble(2);
    std::vector<SparseCode> codes;
    for (const std::size_t m : {0, 1, 2}) codes.push_back(encoded(ensemble, m, DataTransform::logPlus));
    for (SparseCode& code : codes)
      for (ChannelCode& channel : code.channels) channel.dictionary = 0;
    const SparseCode two = interpolateCodes(ensemble, std::span(codes).first(2), std::vector{0.4, 0.6}, 5000),
                     three = interpolateCodes(ensemble, codes, std::vector{0.4, 0.6, 0.0}, 5000);
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(three.channels[c].coefficients.size(), two.channels[c].coefficients.size());
      for (const Coefficient<float>& coefficient : three.channels[c].coefficients) QVERIFY(coefficient.value != 0);
    }
  }

  void hardCase50SameBitsForAnyThreads() {
    const Ensemble ensemble = randomEnsemble(3);
    const std::vector<SparseCode> codes{encoded(ensemble, 0, DataTransform::logPlus),
                                        encoded(ensemble, 2, DataTransform::logPlus)};
    std::vector<SparseCode> results;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      results.push_back(interpolateCodes(ensemble, codes, std::vector{0.4, 0.6}, 200));
    }
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t i = 0; i < results[0].channels[c].coefficients.size(); ++i) {
        const auto &a = results[0].channels[c].coefficients[i], &b = results[1].channels[c].coefficients[i];
        QVERIFY(a.index == b.index && std::memcmp(&a.value, &b.value, sizeof(float)) == 0);
      }
  }

  void foreignCodesAreRefused() {
    const Ensemble ensemble = randomEnsemble(2);
    std::vector<SparseCode> codes(2, encoded(ensemble, 0, DataTransform::logPlus));
    codes[1].channels[2].dictionary = 2;
    QVERIFY_EXCEPTION_THROWN(interpolateCodes(ensemble, codes, std::vector{0.5, 0.5}, 10), Error);
    // Where the slider stands does not matter.
    QVERIFY_EXCEPTION_THROWN(interpolateCodes(ensemble, codes, std::vector{1.0, 0.0}, 10), Error);
  }

  /// A budget keeps the largest: no other choice of as many has a smaller error.
  void budgetKeepsTheLargest() {
    const Ensemble ensemble = randomEnsemble(3);
    const std::vector<SparseCode> codes{encoded(ensemble, 0, DataTransform::logPlus),
                                        encoded(ensemble, 2, DataTransform::logPlus)};
    const SparseCode all = interpolateCodes(ensemble, codes, std::vector{0.4, 0.6}, smallGrid.size());
    const SparseCode few = interpolateCodes(ensemble, codes, std::vector{0.4, 0.6}, 40);
    for (std::size_t c = 0; c < 3; ++c) {
      QCOMPARE(few.channels[c].coefficients.size(), std::size_t(40));
      for (std::size_t i = 0; i < 40; ++i)
        QCOMPARE(few.channels[c].coefficients[i].index, all.channels[c].coefficients[i].index);
    }
  }
};

GONIO_TEST(CodeInterpolationTest)
}  // namespace code_interpolation_test

#include "code_interpolation_test.moc"
