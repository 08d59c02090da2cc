// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/encode.h"

#include <QTest>
#include <limits>

#include "core/dictionary/code_interpolation.h"
#include "core/dictionary/code_packing.h"
#include "core/dictionary/decode.h"
#include "core/dictionary/mode_products.h"
#include "core/math/decompositions.h"
#include "tests/core/dictionary/code_test_support.h"
#include "tests/support/test_program.h"

namespace encode_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

/// Of the scaled signals over the valid cells, all channels: what encoding lowers.
double squaredError(const Ensemble& ensemble, const SparseCode& code, const TabulatedBrdf& table) {
  const auto geometry = GridGeometry::of(table.grid());
  const auto signals = signalsOf(table, code.transform, *geometry);
  const auto decoded = decodeSignals(ensemble, code);
  double error = 0;
  for (std::size_t cell = 0; cell < table.grid().size(); ++cell) {
    if (table.valid()[cell] == 0) continue;
    const double scale = cellScalingOf(table.grid(), *geometry, cell);
    for (std::size_t c = 0; c < 3; ++c)
      error += std::pow(signals[c][Eigen::Index(cell)] - scale * decoded[c][Eigen::Index(cell)], 2);
  }
  return error;
}

/// The squared error of a signal over each dictionary, with so many coefficients.
Eigen::ArrayXd errorsByBruteForce(const Ensemble& ensemble, const Eigen::ArrayXd& signal, std::size_t coefficients) {
  Eigen::ArrayXd errors(Eigen::Index(ensemble.dictionaries.size()));
  for (std::size_t d = 0; d < ensemble.dictionaries.size(); ++d) {
    Workspace<double> workspace;
    const double* projection =
        transposedModeProducts(signal.data(), modeSizes(smallGrid), ensemble.dictionaries[d].modes, workspace);
    std::vector<Coefficient<double>> kept;
    selectLargest(std::span(projection, smallGrid.size()), coefficients, kept);
    errors[Eigen::Index(d)] = signal.square().sum() - energy<double>(kept);
  }
  return errors;
}

class EncodeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Exact in double: the tensor from all its coefficients.
  void exactInDouble() {
    std::mt19937_64 random(3);
    const Sizes sizes{9, 8, 7};
    const ModeMatrices<double> matrices = randomDictionary(sizes, random);
    const Eigen::VectorXd signal = Eigen::VectorXd::Random(Eigen::Index(count(sizes)));
    Workspace<double> workspace;
    const double* projection = transposedModeProducts(signal.data(), sizes, matrices, workspace);
    std::vector<Coefficient<double>> all;
    selectLargest(std::span(projection, count(sizes)), count(sizes), all);
    Eigen::VectorXd decoded(signal.size());
    compose(matrices, all, decoded.data());
    QVERIFY((decoded - signal).norm() < 1e-12 * signal.norm());
  }

  /// By brute force over all of them: the dictionary that is best for all channels together, or for each the one that
  /// holds most, if these have less than 1 / 1.35 of the error.
  void choosesTheBestDictionaries() {
    const Ensemble ensemble = randomEnsemble(5);
    const auto geometry = GridGeometry::of(smallGrid);
    const TrainingMaterials materials = ggxMaterials(4);
    const EncodeOptions options{.coefficients = 30, .transforms = {DataTransform::logPlus}, .refinements = 0};
    const Encoder encoder(ensemble);
    for (std::size_t m = 0; m < 4; ++m) {
      const SparseCode code = encoder.encode(*materials.load(m), options).code;
      const auto signals = signalsOf(*materials.load(m), DataTransform::logPlus, *geometry);
      std::array<Eigen::ArrayXd, 3> errors;
      for (std::size_t c = 0; c < 3; ++c) errors[c] = errorsByBruteForce(ensemble, signals[c], 30);
      const Eigen::ArrayXd common = errors[0] + errors[1] + errors[2];
      const double separate = errors[0].minCoeff() + errors[1].minCoeff() + errors[2].minCoeff();
      for (std::size_t c = 0; c < 3; ++c) {
        const ChannelCode& channel = code.channels[c];
        Eigen::Index expected = 0;
        (common.minCoeff() <= 1.35 * separate ? common : errors[c]).minCoeff(&expected);
        QCOMPARE(channel.dictionary, int(expected));
        const double captured = signals[c].square().sum() - errors[c][expected];
        QVERIFY(std::abs(energy<float>(channel.coefficients) / captured - 1) < 1e-5);
      }
    }
  }

  /// Reciprocal tables: a dictionary for more coefficients than commonSparsity also has to be better by the gamma error
  /// after all rounds, whatever the energy, which includes the invalid cells.
  void dictionariesOfBothOrdersHaveToBeBetterAfterAllRounds() {
    const TrainingMaterials materials = ggxMaterials(4);
    const EncodeOptions options{.coefficients = 30, .transforms = {DataTransform::logPlus}};
    int replaced = 0, stayed = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
      Ensemble common = randomEnsemble(2, seed), large = randomEnsemble(2, 100 + seed);
      for (Dictionary& dictionary : common.dictionaries) dictionary.sparsity = commonSparsity;
      for (Dictionary& dictionary : large.dictionaries) dictionary.sparsity = 1024;
      const Ensemble both = joined(common, large);
      for (std::size_t m = 0; m < 4; ++m) {
        const auto table = materials.load(m);
        const auto errorOver = [&](const Ensemble& ensemble) {
          return Encoder(ensemble).encode(*table, options).candidates[0].gammaError;
        };
        EncodeOptions energy = options;
        energy.refinements = 0;
        const bool isLargeByEnergy = Encoder(both).encode(*table, energy).code.channels[0].dictionary >= 2;
        const double ofCommon = errorOver(common), ofLarge = errorOver(large);
        const bool isLarge = isLargeByEnergy && ofLarge <= ofCommon;
        const EncodeResult found = Encoder(both).encode(*table, options);
        QCOMPARE(found.code.channels[0].dictionary >= 2, isLarge);
        QVERIFY(std::abs(found.candidates[0].gammaError / (isLarge ? ofLarge : ofCommon) - 1) < 1e-6);
        replaced += isLargeByEnergy && !isLarge;
        stayed += isLarge;
      }
    }
    QVERIFY2(replaced > 0 && stayed > 0, qPrintable(QString("%1 replaced, %2 stayed").arg(replaced).arg(stayed)));
  }

  /// Three materials as the channels of one, and a dictionary for each, of which the first atoms are its principal
  /// ones.
  void unlikeChannelsHaveDictionariesOfTheirOwn() {
    const TrainingMaterials materials = ggxMaterials(3);
    const Sizes sizes = modeSizes(smallGrid);
    std::vector<TabulatedBrdf::Value> values(smallGrid.size());
    Ensemble ensemble{.grid = smallGrid, .dictionaries = {}, .learnedFrom = {}};
    for (int c = 0; c < 3; ++c) {
      const auto table = materials.load(std::size_t(c));
      for (std::size_t cell = 0; cell < values.size(); ++cell) values[cell][c] = table->values()[cell][c];
      const auto signals = signalsOf(*table, DataTransform::logPlus, *GridGeometry::of(smallGrid));
      Dictionary dictionary;
      for (int mode = 0; mode < 3; ++mode) {
        const int size = sizes[std::size_t(mode)];
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size, size);
        addGram(signals[std::size_t(c)].data(), sizes, mode, gram);
        dictionary.modes[std::size_t(mode)] = eigenBasis(gram).vectors;
      }
      ensemble.dictionaries.push_back(dictionary);
    }
    const auto valid = materials.load(0)->valid();
    const TabulatedBrdf mixed(smallGrid, values, {valid.begin(), valid.end()});
    const SparseCode code =
        Encoder(ensemble).encode(mixed, {.coefficients = 40, .transforms = {DataTransform::logPlus}}).code;
    for (int c = 0; c < 3; ++c) QCOMPARE(code.channels[std::size_t(c)].dictionary, c);
  }

  /// Rounds that free the invalid cells lower the error of the valid ones; those after the trial never raise the one
  /// that the selection goes by.
  void refinementsServeTheValidCells() {
    const TrainingMaterials materials = ggxMaterials(6);
    const Ensemble ensemble = randomEnsemble(3);
    const Encoder encoder(ensemble);
    double trial = 0, all = 0;
    for (std::size_t m = 0; m < 6; ++m) {
      const auto table = materials.load(m);
      const auto encoded = [&](int refinements) {
        return encoder.encode(*table,
                              {.coefficients = 60, .transforms = {DataTransform::logPlus}, .refinements = refinements});
      };
      const EncodeResult none = encoded(0), three = encoded(3), fifteen = encoded(15);
      QVERIFY(squaredError(ensemble, three.code, *table) < squaredError(ensemble, none.code, *table));
      QVERIFY(fifteen.candidates[0].gammaError <= three.candidates[0].gammaError);
      trial += three.candidates[0].gammaError;
      all += fifteen.candidates[0].gammaError;
    }
    QVERIFY(all < trial);
  }

  /// The rounds after the trial are for the chosen transform alone.
  void onlyTheChosenIsRefinedFurther() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(3).load(2);
    const Encoder encoder(ensemble);
    const EncodeResult trial = encoder.encode(*table, {.coefficients = 80, .refinements = 3});
    const EncodeResult full = encoder.encode(*table, {.coefficients = 80});
    const std::size_t chosen = full.code.transform == full.candidates[0].code.transform ? 0 : 1;
    QVERIFY(full.code.transform == trial.code.transform);
    QVERIFY(sameBits(full.candidates[1 - chosen].code, trial.candidates[1 - chosen].code));
    QVERIFY(!sameBits(full.candidates[chosen].code, trial.candidates[chosen].code));
    QVERIFY(sameBits(full.candidates[chosen].code, full.code));
    // As if all rounds had been made at once.
    const EncodeResult alone =
        encoder.encode(*table, {.coefficients = 80, .transforms = {full.code.transform}, .trialRefinements = 15});
    QVERIFY(sameBits(alone.code, full.code));
  }

  void selectionGoesByTheGammaError() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(3).load(2);
    const EncodeResult encoded = Encoder(ensemble).encode(*table, {.coefficients = 80});
    QCOMPARE(encoded.candidates.size(), std::size_t(2));
    const bool first = encoded.candidates[0].gammaError <= encoded.candidates[1].gammaError;
    QVERIFY(encoded.code.transform == encoded.candidates[first ? 0 : 1].code.transform);
    // By hand, over the valid cells within 85 degrees.
    const auto decoded = decode(ensemble, encoded.candidates[1].code);
    double sum = 0, weights = 0;
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      const DirectionPair pair = smallGrid.directions(cell);
      if (table->valid()[cell] == 0 || std::min(pair.wi.z, pair.wo.z) < std::cos(radians(85))) continue;
      const double weight = smallGrid.cellMeasure(cell) * pair.wi.z * pair.wo.z;
      weights += weight;
      for (int c = 0; c < 3; ++c)
        sum += weight *
               std::pow(std::sqrt(double(table->values()[cell][c])) - std::sqrt(double(decoded->values()[cell][c])), 2);
    }
    QVERIFY(std::abs(encoded.candidates[1].gammaError / (sum / (3 * weights)) - 1) < 1e-9);
  }

  /// Also where the plain squared error would choose otherwise.
  void selectionDoesNotGoByTheSquaredError() {
    const Ensemble ensemble = randomEnsemble(2);
    const Encoder encoder(ensemble);
    int differ = 0;
    // Sharp highlights, by which the squared error goes alone, over bodies.
    for (const double alpha : {0.02, 0.04, 0.08})
      for (const std::size_t coefficients : {10, 40, 160, 640, 1200}) {
        const auto table = bakeTable(*test::ggx(Rgb(0.3), Rgb(1), alpha, 0.5), smallGrid);
        const EncodeResult encoded = encoder.encode(*table, {.coefficients = coefficients, .gamma = 3});
        const auto &first = encoded.candidates[0], &second = encoded.candidates[1];
        const bool chooseFirst = first.gammaError <= second.gammaError;
        QVERIFY(encoded.code.transform == (chooseFirst ? first : second).code.transform);
        differ += chooseFirst != (first.squaredError <= second.squaredError);
      }
    QVERIFY(differ > 0);
  }

  void errorAndByteBudgetsHold() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(1).load(0);
    const Encoder encoder(ensemble);
    // Made anew each time: GCC 14 warns of the bounds of a copied list of one.
    const auto all = [] {
      return EncodeOptions{.coefficients = 2000, .transforms = {DataTransform::logPlus}, .refinements = 0};
    };
    EncodeOptions limited = all();
    limited.relativeError = 1e-2;
    const EncodeResult encoded = encoder.encode(*table, limited);
    const auto signals = signalsOf(*table, DataTransform::logPlus, *GridGeometry::of(smallGrid));
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& kept = encoded.code.channels[c].coefficients;
      const double total = signals[c].square().sum();
      QVERIFY(total - energy<float>(kept) <= 1e-2 * total);
      QVERIFY(total - energy<float>(std::span(kept).first(kept.size() - 1)) > 1e-2 * total);
    }
    for (const std::size_t bytes : {100, 1000, 4000}) {
      limited = all();
      limited.bytes = bytes;
      const SparseCode code = encoder.encode(*table, limited).code;
      QVERIFY(packChannels(code, CodePrecision::quantised).size() <= bytes);
      QVERIFY(
          code.coefficients() == 2000 ||
          packChannels(encoder.encode(*table, all()).code.truncated(code.coefficients() + 1), CodePrecision::quantised)
                  .size() > bytes);
    }
    QCOMPARE(encoder.encode(*table, {.coefficients = 50, .bytes = 3}).code.coefficients(), std::size_t(0));
  }

  /// Without the scale a code represents the transformed values themselves: its coefficients are their largest
  /// projections, and decoding needs no division.
  void publishedCodesHaveNoScale() {
    const Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(2).load(1);
    EncodeOptions options = publishedEncodeOptions(30);
    options.transforms = {DataTransform::logPlus};
    const EncodeResult encoded = Encoder(ensemble).encode(*table, options);
    QVERIFY(!encoded.code.scaled);
    const auto geometry = GridGeometry::of(smallGrid);
    const auto signals = signalsOf(*table, DataTransform::logPlus, *geometry, false);
    const auto decoded = decodeSignals(ensemble, encoded.code);
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell)
      if (table->valid()[cell] != 0)
        QVERIFY(std::abs(signals[0][Eigen::Index(cell)] - std::log1p(double(table->values()[cell].x))) < 1e-6);
    for (std::size_t c = 0; c < 3; ++c) {
      const ChannelCode& channel = encoded.code.channels[c];
      const Eigen::ArrayXd& signal = signals[c];
      const auto largestOver = [&](const Dictionary& dictionary) {
        Workspace<double> workspace;
        const double* projection =
            transposedModeProducts(signal.data(), modeSizes(smallGrid), dictionary.modes, workspace);
        std::vector<Coefficient<double>> largest;
        selectLargest(std::span(projection, smallGrid.size()), 30, largest);
        return largest;
      };
      auto largest = largestOver(ensemble.dictionaries[std::size_t(channel.dictionary)]);
      // The best dictionary of each channel, and no bounds.
      for (const Dictionary& other : ensemble.dictionaries)
        QVERIFY(energy<double>(largestOver(other)) <= (1 + 1e-5) * energy<double>(largest));
      QCOMPARE(channel.highest, std::numeric_limits<float>::max());
      QVERIFY(!encoded.code.hasLargestValues);
      QCOMPARE(channel.coefficients.size(), std::size_t(30));
      // To the last bit of single precision: the projections are computed in double.
      std::ranges::sort(largest, isLarger<double>);
      for (std::size_t i = 0; i < largest.size(); ++i) {
        QCOMPARE(channel.coefficients[i].index, largest[i].index);
        QVERIFY(std::abs(double(channel.coefficients[i].value) / largest[i].value - 1) <= 0x1p-23);
      }
      // Parseval: the error is the energy that was left out. Clamping to the largest value only lowers it.
      const double left = (signal - decoded[c]).square().sum();
      QVERIFY(left <= (1 + 1e-4) * (signal.square().sum() - energy<double>(largest)));
    }
    // The mean of the gamma error is over the cells, by hand.
    const auto values = decode(ensemble, encoded.code);
    double sum = 0, count = 0;
    for (std::size_t cell = 0; cell < smallGrid.size(); ++cell) {
      const DirectionPair pair = smallGrid.directions(cell);
      if (table->valid()[cell] == 0 || std::min(pair.wi.z, pair.wo.z) < std::cos(radians(85))) continue;
      for (int c = 0; c < 3; ++c, ++count)
        sum += std::pow(std::sqrt(double(table->values()[cell][c])) - std::sqrt(double(values->values()[cell][c])), 2);
    }
    QVERIFY(std::abs(encoded.candidates[0].gammaError / (sum / count) - 1) < 1e-9);
  }

  /// Over an ensemble that was trained without the scale no code has it, and codes of both kinds are not mixed.
  void ensemblesWithoutTheScale() {
    Ensemble ensemble = randomEnsemble(2);
    const auto table = ggxMaterials(2).load(0);
    const SparseCode scaled = Encoder(ensemble).encode(*table, {.coefficients = 50}).code;
    ensemble.scaled = false;
    const SparseCode unscaled =
        Encoder(ensemble).encode(*table, {.coefficients = 50, .transforms = {scaled.transform}}).code;
    QVERIFY(scaled.scaled && !unscaled.scaled);
    QVERIFY(relativeDifference(*table, *decode(ensemble, unscaled)) < 0.7);
    const std::array codes{scaled, unscaled};
    const std::array weights{0.5, 0.5};
    QVERIFY_EXCEPTION_THROWN(interpolateCodes(ensemble, codes, weights, 50), Error);
    const auto brdf = makeCodeBrdf(ensemble, unscaled);
    const auto decoded = decode(ensemble, unscaled);
    for (const std::size_t cell : {20, 700, 1500}) {
      const DirectionPair pair = smallGrid.directions(cell);
      if (decoded->valid()[cell] == 0) continue;
      const double expected = double(decoded->values()[cell].y);
      QVERIFY(std::abs(brdf->evaluate(pair.wi, pair.wo).y - expected) < 1e-3 * std::max(1e-2, expected));
    }
  }

  void packsAndUnpacks() {
    const Ensemble ensemble = randomEnsemble(2);
    const EncodeResult encoded = Encoder(ensemble).encode(*ggxMaterials(1).load(0), {.coefficients = 300});
    SparseCode single{.grid = smallGrid,
                      .transform = encoded.code.transform,
                      .hasLargestValues = encoded.code.hasLargestValues,
                      .channels = {}},
        half = single;
    unpackChannels(packChannels(encoded.code, CodePrecision::single), CodePrecision::single, single);
    QVERIFY(sameBits(single, encoded.code));
    const std::vector<std::byte> packed = packChannels(encoded.code, CodePrecision::half);
    unpackChannels(packed, CodePrecision::half, half);
    QVERIFY(relativeDifference(*decode(ensemble, encoded.code), *decode(ensemble, half)) < 1e-3);
    QVERIFY(packed.size() < 3 * (7 + 300 * 4));
    // Every cut and every wrong byte count is reported.
    SparseCode target = half;
    for (std::size_t size = 0; size < packed.size(); ++size)
      QVERIFY_EXCEPTION_THROWN(unpackChannels(std::span(packed).first(size), CodePrecision::half, target), Error);
    std::vector<std::byte> longer = packed;
    longer.push_back({});
    QVERIFY_EXCEPTION_THROWN(unpackChannels(longer, CodePrecision::half, target), Error);
  }

  void foreignCodesAreRefused() {
    const Ensemble ensemble = randomEnsemble(2);
    SparseCode code{.grid = {}, .transform = DataTransform::logPlus, .channels = {}};
    QVERIFY_EXCEPTION_THROWN(decode(ensemble, code), Error);
    code.grid = smallGrid;
    code.channels[1].dictionary = 2;
    QVERIFY_EXCEPTION_THROWN(decode(ensemble, code), Error);
    code.channels[1].dictionary = 1;
    code.channels[1].coefficients.push_back({std::uint32_t(smallGrid.size()), 1.0f});
    QVERIFY_EXCEPTION_THROWN(decode(ensemble, code), Error);
    QVERIFY_EXCEPTION_THROWN(Encoder(ensemble).encode(*bakeTable(test::lambert(Rgb(0.5)), {8, 8, 8, true})), Error);
  }
};

GONIO_TEST(EncodeTest)
}  // namespace encode_test

#include "encode_test.moc"
