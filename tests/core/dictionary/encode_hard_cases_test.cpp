// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/dictionary/decode.h"
#include "core/dictionary/encode.h"
#include "core/math/parallel.h"
#include "tests/core/dictionary/code_test_support.h"
#include "tests/support/linear_oracles.h"
#include "tests/support/test_program.h"

namespace encode_hard_cases_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

class EncodeHardCasesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Black materials and black channels give zeros back, exactly.
  void hardCase12BlackChannels() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = bakeTable(test::lambert(Rgb(0, 0.5, 0)), smallGrid);
    const EncodeResult encoded = Encoder(ensemble).encode(*table, {.coefficients = 40});
    const auto decoded = decode(ensemble, encoded.code);
    for (const TabulatedBrdf::Value& value : decoded->values()) QVERIFY(value.x == 0 && value.z == 0);
    QVERIFY(encoded.code.channels[0].coefficients.empty());
  }

  /// One coefficient where each mode has a constant atom, in log-plus; elsewhere more lower the error.
  void hardCase14Constant() {
    const auto table = bakeTable(test::lambert(Rgb(0.5)), smallGrid);
    const Ensemble ensemble = randomEnsemble(2);
    double last = 1e300;
    for (const std::size_t coefficients : {1, 10, 100, 1000, int(smallGrid.size())}) {
      const EncodeOptions options{.coefficients = coefficients, .transforms = {DataTransform::logPlus}};
      const double error = Encoder(ensemble).encode(*table, options).candidates[0].gammaError;
      QVERIFY(error < last);
      last = error;
    }
    QVERIFY(last < 1e-10);
    // Atoms along the signal itself: of a constant it is a product, however its cells are scaled.
    Ensemble constant = ensemble;
    const Eigen::ArrayXd signal = signalsOf(*table, DataTransform::logPlus, *GridGeometry::of(smallGrid))[0];
    const auto sizes = modeSizes(smallGrid);
    const std::array<Eigen::Index, 3> strides{1, sizes[0], Eigen::Index(sizes[0]) * sizes[1]};
    for (std::size_t mode = 0; mode < 3; ++mode) {
      Eigen::MatrixXd m = ensemble.dictionaries[0].modes[mode];
      for (Eigen::Index i = 0; i < m.rows(); ++i) m(i, 0) = signal[i * strides[mode]];
      constant.dictionaries[1].modes[mode] = test::orthonormalised(m);
    }
    const EncodeResult encoded =
        Encoder(constant).encode(*table, {.coefficients = 1, .transforms = {DataTransform::logPlus}});
    QCOMPARE(encoded.code.channels[0].dictionary, 1);
    QVERIFY(relativeDifference(*table, *decode(constant, encoded.code)) < 1e-5);
  }

  /// A spike of 1e6 stands in one coefficient of the standard basis, and comes back.
  void hardCase15OneSpike() {
    Ensemble ensemble{.grid = smallGrid, .dictionaries = {}, .learnedFrom = {}};
    Dictionary standard;
    for (std::size_t mode = 0; mode < 3; ++mode)
      standard.modes[mode] = Eigen::MatrixXd::Identity(modeSizes(smallGrid)[mode], modeSizes(smallGrid)[mode]);
    ensemble.dictionaries.push_back(standard);
    std::vector<TabulatedBrdf::Value> values(smallGrid.size(), glm::vec3(0));
    const std::size_t spike = smallGrid.index(0, 3, 5);
    values[spike] = glm::vec3(1e6f);
    const auto above = GridGeometry::of(smallGrid)->aboveHorizon;
    const TabulatedBrdf table(smallGrid, values, above);
    const EncodeResult encoded =
        Encoder(ensemble).encode(table, {.coefficients = 5, .transforms = {DataTransform::logPlus}});
    const auto decoded = decode(ensemble, encoded.code);
    QVERIFY(std::abs(decoded->values()[spike].x / 1e6f - 1) < 1e-5f);
    QCOMPARE(encoded.code.channels[0].coefficients.size(), std::size_t(1));
  }

  /// Codes that overshoot stay finite.
  void hardCase39NoInfinityInATable() {
    const Ensemble ensemble = randomEnsemble(1);
    SparseCode code{.grid = smallGrid, .transform = DataTransform::cosineLog, .channels = {}};
    for (ChannelCode& channel : code.channels) channel.coefficients = {{0, 1e6f}, {1, -1e6f}};
    const auto decoded = decode(ensemble, code);
    for (const TabulatedBrdf::Value& value : decoded->values())
      for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
  }

  /// One cell near the horizon in a black table: the inverse of cosine-log divides by weights down to 1e-3, but no
  /// decoded value exceeds the measured one, also in a file and in a blend.
  void hardCase55CosineLogStaysBelowTheMeasurement() {
    const Ensemble ensemble = randomEnsemble(1);
    const auto geometry = GridGeometry::of(smallGrid);
    std::size_t brightest = 0;  // of the valid cells the one that faces both directions most
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
      if (geometry->weights[Eigen::Index(cell)] > geometry->weights[Eigen::Index(brightest)]) brightest = cell;
    std::vector<TabulatedBrdf::Value> values(smallGrid.size(), TabulatedBrdf::Value(0));
    values[brightest] = TabulatedBrdf::Value(0.3f, 0.2f, 0);
    const TabulatedBrdf table(smallGrid, values, geometry->aboveHorizon);
    const EncodeOptions options{.coefficients = 20, .transforms = {DataTransform::cosineLog}};
    const SparseCode code = Encoder(ensemble).encode(table, options).code;
    QVERIFY(code.hasLargestValues);
    SparseCode unbounded = code,
               read{.grid = code.grid, .transform = code.transform, .hasLargestValues = true, .channels = {}};
    for (ChannelCode& channel : unbounded.channels) channel.largestValue = ChannelCode().largestValue;
    const auto largest = [&](const SparseCode& one) {
      glm::vec3 most(0);
      const auto decoded = decode(ensemble, one);
      for (const TabulatedBrdf::Value& value : decoded->values()) most = glm::max(most, value);
      return most;
    };
    QVERIFY2(largest(unbounded).x > 0.35f, qPrintable(QString::number(largest(unbounded).x)));
    for (const CodePrecision precision : {CodePrecision::single, CodePrecision::half, CodePrecision::quantised}) {
      unpackChannels(packChannels(code, precision), precision, read);
      const glm::vec3 most = largest(read);
      QVERIFY2(most.x <= 0.3f && most.y <= 0.2f && most.z == 0,
               qPrintable(QString("%1 %2 %3").arg(most.x).arg(most.y).arg(most.z)));
    }
    const auto brdf = makeCodeBrdf(ensemble, code);
    for (std::size_t cell = 0; cell < smallGrid.size(); cell += 7) {
      const DirectionPair pair = smallGrid.directions(cell);
      QVERIFY(brdf->evaluate(pair.wi, pair.wo).x <= 0.3 * (1 + 1e-6));
    }
    const std::vector<SparseCode> codes{code, code.truncated(5)};
    const std::vector<double> weights{0.5, 0.5};
    QVERIFY(largest(interpolateCodes(ensemble, codes, weights, 50)).x <= 0.3f);
  }

  /// A hot pixel that the code loses is named with its value; a code with all coefficients loses nothing.
  void hardCase60LostPeak() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(1).load(0);
    std::vector<TabulatedBrdf::Value> values(table->values().begin(), table->values().end());
    const std::size_t hot = smallGrid.index(2, 1, 0);
    QVERIFY(table->valid()[hot] != 0);
    values[hot].y = 1e8f;
    const TabulatedBrdf spiked(smallGrid, values, {table->valid().begin(), table->valid().end()});
    const Encoder encoder(ensemble);
    const auto lost = lostPeaks(spiked, *decode(ensemble, encoder.encode(spiked, {.coefficients = 3}).code));
    QVERIFY(std::ranges::any_of(lost, [](const std::string& text) {
      return text.starts_with("the brightest cell in green") &&
             text.find(", 1e+08 1/sr, is lost: the code has ") != text.npos;
    }));
    const EncodeOptions all{.coefficients = smallGrid.size(), .transforms = {DataTransform::logPlus}};
    QVERIFY(lostPeaks(spiked, *decode(ensemble, encoder.encode(spiked, all).code)).empty());
    QVERIFY(lostPeaks(*table, *table).empty());
  }

  /// With all coefficients a code is the material, in any dictionary and both transforms.
  void hardCase26ExactWithAllCoefficients() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(1).load(0);
    const Encoder encoder(ensemble);
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      const EncodeResult encoded =
          encoder.encode(*table, {.coefficients = smallGrid.size(), .transforms = {transform}});
      QVERIFY(relativeDifference(*table, *decode(ensemble, encoded.code)) < 1e-5);
    }
    // None at all: black.
    const EncodeResult none = encoder.encode(*table, {.coefficients = 0});
    const auto black = decode(ensemble, none.code);
    for (const TabulatedBrdf::Value& value : black->values()) QVERIFY(value == glm::vec3(0));
  }

  void hardCase50SameBitsForAnyThreads() {
    const Ensemble ensemble = randomEnsemble(3);
    const auto table = ggxMaterials(1).load(0);
    std::vector<SparseCode> codes;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      codes.push_back(Encoder(ensemble).encode(*table, {.coefficients = 50}).code);
    }
    QVERIFY(sameBits(codes[0], codes[1]));
  }
};

GONIO_TEST(EncodeHardCasesTest)
}  // namespace encode_hard_cases_test

#include "encode_hard_cases_test.moc"
