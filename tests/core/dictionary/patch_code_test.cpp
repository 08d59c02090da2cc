// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/dictionary/alternatives/patch_dictionary.h"

#include <QTest>
#include <cmath>

#include "core/math/parallel.h"
#include "tests/core/dictionary/dictionary_test_support.h"
#include "tests/support/test_program.h"

namespace patch_code_test {
using namespace gonio;
using namespace gonio::dictionary;
using namespace gonio::dictionary::test_support;

constexpr Sizes patch{4, 3, 3};

Eigen::MatrixXd materialPatches(std::size_t material) {
  const auto signals = signalsOf(*ggxMaterials(6).load(material), DataTransform::logPlus, *GridGeometry::of(smallGrid));
  return patchesOf(signals[0], modeSizes(smallGrid), patch);
}

double relativeError(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).norm() / a.norm(); }

Eigen::MatrixXd decodePatches(const AtomSet& atoms, const PatchCode& code) {
  Eigen::MatrixXd patches = Eigen::MatrixXd::Zero(atoms.length(), Eigen::Index(code.patches.size()));
  for (std::size_t p = 0; p < code.patches.size(); ++p)
    for (std::size_t i = 0; i < code.patches[p].atoms.size(); ++i)
      patches.col(Eigen::Index(p)) += code.patches[p].coefficients[i] * atoms.matrix().col(code.patches[p].atoms[i]);
  return patches;
}

class PatchCodeTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every cell is in exactly one patch.
  void patchesTileASignal() {
    const Sizes sizes{8, 6, 9};
    const Eigen::ArrayXd signal = Eigen::ArrayXd::LinSpaced(Eigen::Index(count(sizes)), 0, double(count(sizes) - 1));
    const Eigen::MatrixXd patches = patchesOf(signal, sizes, patch);
    QCOMPARE(patches.rows(), Eigen::Index(36));
    QCOMPARE(patches.cols(), Eigen::Index(12));
    // Cell (3, 2, 1) of patch (1, 0, 2).
    QCOMPARE(patches(3 + 4 * (2 + 3 * 1), 1 + 2 * (0 + 2 * 2)), double(4 + 3 + 8 * (0 + 2 + 6 * (6 + 1))));
    QVERIFY((signalOf(patches, sizes, patch) == signal).all());
    QVERIFY_EXCEPTION_THROWN(patchesOf(signal, sizes, {5, 3, 3}), Error);
    QVERIFY_EXCEPTION_THROWN(patchesOf(signal, sizes, {4, 3, 0}), Error);
  }

  /// Over an orthonormal basis, a code with all coefficients is exact; shorter codes have at most as many as asked for.
  void budgetsHoldAndAllIsExact() {
    std::mt19937_64 random(1);
    const AtomSet basis(randomOrthonormal(36, random));
    const Eigen::MatrixXd patches = materialPatches(2);
    const PatchCode all = encodePatches(basis, patches, std::size_t(patches.size()), 36);
    QVERIFY(relativeError(patches, decodePatches(basis, all)) < 1e-4);
    double last = 1;
    for (const std::size_t coefficients : {0, 20, 100, 500}) {
      const PatchCode code = encodePatches(basis, patches, coefficients);
      QVERIFY(code.coefficients() <= coefficients);
      QVERIFY(code.coefficients() >= coefficients * 9 / 10);
      const double error = relativeError(patches, decodePatches(basis, code));
      QVERIFY(error < last || (coefficients == 0 && error == 1));
      last = error;
    }
  }

  /// Equal to a bisection that encodes all patches again for every error that it tries.
  void patchesShareOneError() {
    std::mt19937_64 random(3);
    Eigen::MatrixXd overcomplete(36, 72);
    overcomplete << randomOrthonormal(36, random), randomOrthonormal(36, random);
    const AtomSet atoms(overcomplete);
    const Eigen::MatrixXd patches = materialPatches(3);
    constexpr int most = 6;
    for (const std::size_t coefficients : {7, 60, 300, 2000}) {
      double tooMany = 0, fits = patches.colwise().norm().maxCoeff();
      std::vector<PursuitResult> best(std::size_t(patches.cols()));
      for (int step = 0; step < 16; ++step) {
        const double error = (tooMany + fits) / 2;
        std::vector<PursuitResult> codes;
        std::size_t sum = 0;
        for (const auto& column : patches.colwise()) {
          const Eigen::VectorXd values = column;
          const double norm = values.norm();
          codes.push_back(
              orthogonalMatchingPursuit(atoms, values, {.steps = most, .residual = norm > 0 ? error / norm : 0}));
          sum += codes.back().atoms.size();
        }
        (sum > coefficients ? tooMany : fits) = error;
        if (sum <= coefficients) best = codes;
      }
      const PatchCode code = encodePatches(atoms, patches, coefficients, most);
      for (std::size_t p = 0; p < best.size(); ++p) {
        QCOMPARE(code.patches[p].atoms, best[p].atoms);
        QCOMPARE(code.patches[p].coefficients, best[p].coefficients);
      }
    }
  }

  void hardCase12BlackPatches() {
    std::mt19937_64 random(1);
    const AtomSet basis(randomOrthonormal(36, random));
    const Eigen::MatrixXd black = Eigen::MatrixXd::Zero(36, 10);
    const PatchCode code = encodePatches(basis, black, 100);
    QCOMPARE(code.coefficients(), std::size_t(0));
    QVERIFY(decodePatches(basis, code) == black);
    QCOMPARE(encodePatches(basis, Eigen::MatrixXd(36, 0), 100).patches.size(), std::size_t(0));
  }

  void canBeCancelled() {
    std::stop_source stop;
    stop.request_stop();
    std::mt19937_64 random(1);
    QVERIFY_EXCEPTION_THROWN(
        encodePatches(AtomSet(randomOrthonormal(36, random)), materialPatches(0), 10, 32, {stop.get_token(), {}}),
        Cancelled);
  }
};

GONIO_TEST(PatchCodeTest)
}  // namespace patch_code_test

#include "patch_code_test.moc"
