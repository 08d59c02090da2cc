// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>

#include "core/dictionary/decode.h"
#include "core/interpolation/interpolation.h"
#include "core/support/error.h"
#include "tests/core/interpolation/interpolation_test_support.h"
#include "tests/support/test_program.h"

namespace interpolation_codes_test {
using namespace gonio;
using namespace gonio::interpolation;
using namespace gonio::editing;
using namespace gonio::editing::test_support;

class InterpolationCodesTest : public QObject, private ThreeMaterials {
  Q_OBJECT
 private Q_SLOTS:
  /// With all coefficients nothing is cut: the code, its table and the mixture of decoded tables are one.
  void dictionaryIsTheMixtureOfTransformedTables() {
    InterpolationOptions all = options();
    all.codeCoefficients = smallGrid.size();
    all.encode.coefficients = 200;
    for (const DataTransform transform : {DataTransform::logPlus, DataTransform::cosineLog}) {
      all.encode.transforms = {transform};
      const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
      const auto code = between->code(weights_).value();
      QVERIFY(code.transform == transform);
      const Table table = between->table(weights_);
      QCOMPARE(maxDifference(*dictionary::decode(*all.ensemble, code), *table), 0.0);
      // Where the sums of no material are cut at its largest value.
      const dictionary::SparseCode ends[] = {between->code(std::vector{1.0, 0.0, 0.0}).value(),
                                             between->code(std::vector{0.0, 1.0, 0.0}).value(),
                                             between->code(std::vector{0.0, 0.0, 1.0}).value()};
      const TransformedMixture mixture = *between->mixture();
      const Table picture = mixed(mixture, weights_);
      std::size_t compared = 0;
      const auto geometry = dictionary::GridGeometry::of(smallGrid);
      for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
        for (int c = 0; c < 3 && table->valid()[cell] != 0; ++c) {
          bool isCut = false;
          for (std::size_t i = 0; i < 3; ++i) {
            const dictionary::ChannelCode& channel = ends[i].channels[std::size_t(c)];
            const double value = std::abs(mixture.tables[i].values[cell][c]),
                         weight = geometry->weights[Eigen::Index(cell)];
            isCut = isCut || value >= channel.highest ||
                    value > (1 - 1e-6) * transformed(transform, double(channel.largestValue), weight);
          }
          const double a = picture->values()[cell][c], b = table->values()[cell][c];
          QVERIFY(a <= (1 + 1e-5) * double(code.channels[std::size_t(c)].largestValue));
          if (isCut) continue;
          ++compared;
          QVERIFY(std::abs(a - b) < 1e-3 * (1 + b));
        }
      QVERIFY(compared > smallGrid.size());
      QVERIFY(between->mixture()->transform == transform);
    }
    all.codeCoefficients = 50;
    const auto few = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    QCOMPARE(few->code(weights_)->coefficients(), std::size_t(50));
  }

  /// With all coefficients a code is its material: the blend is that of the transformed reflectances.
  void dictionaryBlendsTransformedReflectances() {
    InterpolationOptions all = options();
    all.encode = {.coefficients = smallGrid.size(), .transforms = {DataTransform::logPlus}};
    all.codeCoefficients = smallGrid.size();
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    const Table table = between->table(weights_);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      if (!(tables_[0]->valid()[cell] && tables_[1]->valid()[cell] && tables_[2]->valid()[cell])) continue;
      for (int c = 0; c < 3; ++c) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) sum += weights_[i] * std::log1p(double(tables_[i]->values()[cell][c]));
        QVERIFY(std::abs(double(table->values()[cell][c]) - std::expm1(sum)) < 1e-3 * (1 + std::expm1(sum)));
      }
    }
  }

  /// Half way from a spike of 1e6 to nothing lies its geometric mean, 1 being added: 999.
  void hardCase15SpikeBesideBlack() {
    dictionary::Dictionary standard;
    const auto sizes = dictionary::modeSizes(smallGrid);
    for (std::size_t mode = 0; mode < 3; ++mode)
      standard.modes[mode] = Eigen::MatrixXd::Identity(sizes[mode], sizes[mode]);
    InterpolationOptions plain = options();
    plain.ensemble = std::make_shared<const dictionary::Ensemble>(
        dictionary::Ensemble{.grid = smallGrid, .dictionaries = {standard}, .learnedFrom = {}});
    plain.encode.transforms = {DataTransform::logPlus};
    const Table black = bakeTable(test::lambert(Rgb(0)), smallGrid);
    std::vector<TabulatedBrdf::Value> values(smallGrid.size(), TabulatedBrdf::Value(0));
    const std::size_t spike = smallGrid.index(0, 3, 5);
    values[spike] = TabulatedBrdf::Value(1e6f);
    const auto spiked = std::make_shared<const TabulatedBrdf>(
        smallGrid, values, std::vector<std::uint8_t>(black->valid().begin(), black->valid().end()));
    const Table half = prepareInterpolation(InterpolationSpace::dictionary, endsOf({spiked, black}), plain)
                           ->table(std::vector{0.5, 0.5});
    QVERIFY(std::abs(half->values()[spike].y / (std::sqrt(1e6f + 1) - 1) - 1) < 1e-5f);
    QVERIFY(half->values()[spike + 1] == TabulatedBrdf::Value(0));
  }

  /// Codes are taken as they are; what has none, or one of another transform, is encoded in that of the first.
  void hardCase31MixedTransformsAreEncodedAgain() {
    const InterpolationOptions all = options();
    const dictionary::Encoder encoder(*all.ensemble);
    const auto encoded = [&](std::size_t i, DataTransform transform) {
      return std::make_shared<const dictionary::SparseCode>(
          encoder.encode(*tables_[i], {.coefficients = 30, .transforms = {transform}}).code);
    };
    std::vector<InterpolationMaterial> ends = ends_;
    ends[1].code = encoded(1, DataTransform::cosineLog);
    ends[2].code = encoded(2, DataTransform::logPlus);
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends, all);
    const auto first = between->code(std::vector{1.0, 0.0, 0.0}).value(),
               second = between->code(std::vector{0.0, 1.0, 0.0}).value(),
               third = between->code(std::vector{0.0, 0.0, 1.0}).value();
    for (const auto& code : {first, second, third}) QVERIFY(code.transform == DataTransform::cosineLog);
    QCOMPARE(second.coefficients(), std::size_t(30));
    QVERIFY(first.coefficients() > 30 && third.coefficients() > 30);
  }

  /// Without codes the transform is the one in which the materials together are nearest.
  void theTransformServesAllMaterials() {
    InterpolationOptions all = options();
    all.encode.coefficients = 60;
    const auto between = prepareInterpolation(InterpolationSpace::dictionary, ends_, all);
    std::array<double, 2> errors{};
    for (const Table& table : tables_) {
      const auto encoded = dictionary::Encoder(*all.ensemble).encode(*table, all.encode);
      for (std::size_t t = 0; t < 2; ++t) errors[t] += encoded.candidates[t].gammaError;
    }
    QVERIFY(between->code(weights_)->transform == all.encode.transforms[errors[1] < errors[0] ? 1 : 0]);
  }

  void codesOfAnotherEnsembleAreRefused() {
    std::vector<InterpolationMaterial> ends = ends_;
    dictionary::SparseCode foreign{.grid = smallGrid, .transform = DataTransform::logPlus, .channels = {}};
    foreign.channels[2].dictionary = 3;
    ends[1].code = std::make_shared<const dictionary::SparseCode>(foreign);
    QVERIFY_EXCEPTION_THROWN(prepareInterpolation(InterpolationSpace::dictionary, ends, options()), Error);
  }
};

GONIO_TEST(InterpolationCodesTest)
}  // namespace interpolation_codes_test

#include "interpolation_codes_test.moc"
