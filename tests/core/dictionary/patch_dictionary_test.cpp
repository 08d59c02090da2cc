// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/patch_dictionary.h"

#include <QTest>
#include <cmath>

#include "core/dictionary/code_packing.h"
#include "core/math/parallel.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace patch_dictionary_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr std::size_t materialCount = 6;

PatchTrainingOptions smallTraining() {
  return {.patch = {4, 3, 3}, .samples = 800, .kSvd = {.atoms = 30, .sparsity = 2, .iterations = 15}};
}

/// Of all materials but the last.
PatchDictionary learned() {
  TrainingMaterials materials = ggxMaterials(materialCount);
  materials.names.pop_back();
  return learnPatchDictionary(materials, smallTraining());
}

/// Relative error of the log-plus values of the valid cells.
double relativeError(const TabulatedBrdf& table, const TabulatedBrdf& decoded) {
  double error = 0, energy = 0;
  for (std::size_t cell = 0; cell < table.values().size(); ++cell)
    for (int c = 0; c < 3 && table.valid()[cell] != 0; ++c) {
      const double value = std::log1p(table.values()[cell][c]);
      error += std::pow(value - std::log1p(decoded.values()[cell][c]), 2);
      energy += value * value;
    }
  return std::sqrt(error / energy);
}

class PatchDictionaryTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Atoms of K-SVD represent another material better than random orthonormal ones.
  void representsOtherMaterials() {
    const PatchDictionary dictionary = learned();
    QCOMPARE(dictionary.atoms.length(), Eigen::Index(36));
    QCOMPARE(dictionary.bytes(), std::size_t(36 * 30 * 4));
    QCOMPARE(dictionary.learnedFrom.size(), materialCount - 1);
    const auto table = ggxMaterials(materialCount).load(materialCount - 1);
    std::mt19937_64 random(2);
    PatchDictionary noise = dictionary;
    noise.atoms = AtomSet(randomOrthonormal(36, random));
    const auto errorOf = [&](const PatchDictionary& by) {
      return relativeError(*table, *decode(by, encode(by, *table, 150)));
    };
    QVERIFY2(errorOf(dictionary) < 0.15, qPrintable(QString::number(errorOf(dictionary))));
    QVERIFY2(errorOf(dictionary) < 0.5 * errorOf(noise), qPrintable(QString::number(errorOf(noise))));
  }

  /// The error decreases with the number of coefficients; over an orthonormal basis, a code with all coefficients is
  /// exact up to quantisation. Codes are packed without loss.
  void coefficientsReduceTheError() {
    std::mt19937_64 random(3);
    const PatchDictionary dictionary{smallGrid, {4, 3, 2}, AtomSet(randomOrthonormal(24, random)), {}};
    const auto table = ggxMaterials(materialCount).load(2);
    double last = 2;
    for (const std::size_t coefficients :
         {std::size_t(0), std::size_t(20), std::size_t(200), dictionary.maxCoefficients()}) {
      const SparseCode code = encode(dictionary, *table, coefficients);
      QVERIFY(code.coefficients() <= coefficients);
      SparseCode unpacked{.grid = code.grid, .transform = code.transform, .channels = {}};
      unpackChannels(packChannels(code, CodePrecision::quantised), CodePrecision::quantised, unpacked);
      const auto decoded = decode(dictionary, unpacked);
      QVERIFY(std::ranges::equal(decoded->values(), decode(dictionary, code)->values()));
      const double error = relativeError(*table, *decoded);
      QVERIFY2(error < last, qPrintable(QString::number(error)));
      last = error;
    }
    QVERIFY2(last < 0.01, qPrintable(QString::number(last)));
  }

  void hardCase50SameBitsForAnyThreads() {
    std::vector<Eigen::MatrixXd> atoms;
    std::vector<std::vector<std::byte>> codes;
    for (const int threads : {1, 16}) {
      const ThreadLimit limit(threads);
      const PatchDictionary dictionary = learned();
      atoms.push_back(dictionary.atoms.matrix());
      codes.push_back(
          packChannels(encode(dictionary, *ggxMaterials(materialCount).load(1), 100), CodePrecision::quantised));
    }
    QVERIFY(atoms[0] == atoms[1] && codes[0] == codes[1]);
  }

  void refusesOtherGridsAndPatches() {
    const PatchDictionary dictionary = learned();
    SparseCode code = encode(dictionary, *ggxMaterials(1).load(0), 10);
    code.channels[0].coefficients.push_back({.index = std::uint32_t(smallGrid.size()), .value = 1});
    QVERIFY_EXCEPTION_THROWN(decode(dictionary, code), Error);
    QVERIFY_EXCEPTION_THROWN(packChannels(code, CodePrecision::quantised), Error);
    code.grid.phiDCount *= 2;
    QVERIFY_EXCEPTION_THROWN(decode(dictionary, code), Error);
    PatchTrainingOptions options = smallTraining();
    options.patch[0] = 5;
    QVERIFY_EXCEPTION_THROWN(learnPatchDictionary(ggxMaterials(2), options), Error);
    options = smallTraining();
    options.kSvd.atoms = 37;
    QVERIFY_EXCEPTION_THROWN(learnPatchDictionary(ggxMaterials(2), options), Error);
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    QVERIFY_EXCEPTION_THROWN(learnPatchDictionary(ggxMaterials(2), smallTraining(), {stop.get_token(), {}}), Cancelled);
  }
};

GONIO_TEST(PatchDictionaryTest)
}  // namespace patch_dictionary_test

#include "patch_dictionary_test.moc"
