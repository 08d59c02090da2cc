// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_samples.h"

#include <QTest>
#include <cmath>

#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace pdv_residuals_test {
using namespace gonio;
using namespace gonio::factorization;

constexpr int terms = 3;

std::shared_ptr<const TabulatedBrdf> glossyTable() {
  models::ParameterValues values = models::defaultParameters(models::ggx().spec());
  values.values[models::ggx().spec().find("roughness").value()] = Rgb(0.2);
  return bakeTable(*models::ggx().instantiate(values), {.thetaHCount = 24, .thetaDCount = 24, .phiDCount = 24});
}

class PdvResidualsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Weighted by the energy at each node, the squares along any axis give those of the factorisation, for either form
  /// and weight.
  void sumsAreThoseOfTheFactorisation() {
    const auto table = glossyTable();
    for (const auto& [form, weights] : {std::pair(PdvForm::twoFactors, PdvWeights::equal),
                                        std::pair(PdvForm::threeFactors, PdvWeights::projectedSolidAngle)}) {
      const auto found = factorizePdv(*table, {.form = form, .terms = terms, .weights = weights});
      const auto along = residualsAlong(*table, found.factors, weights);
      QCOMPARE(along.size(), std::size_t(terms));
      const PdvSamples samples = samplePdv(*table, found.factors, weights);
      for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> energy(along[0][std::size_t(axis)].size(), 0);
        for (const MaskedTensor& t : samples.channels)
          for (int i = 0; i < t.sizes[0]; ++i)
            for (int j = 0; j < t.sizes[1]; ++j)
              for (int k = 0; k < t.sizes[2]; ++k) {
                const double y = t.values[t.index(i, j, k)];
                energy[std::size_t(axis == 0 ? i : axis == 1 ? j : k)] += t.weights[t.index(i, j, k)] * y * y;
              }
        for (std::size_t count = 1; count <= terms; ++count) {
          double left = 0, all = 0;
          for (std::size_t node = 0; node < energy.size(); ++node) {
            const double fraction = along[count - 1][std::size_t(axis)][node];
            left += energy[node] * fraction * fraction;
            all += energy[node];
          }
          QVERIFY(std::abs(std::sqrt(left / all) - found.residuals[count]) < 1e-4);
        }
      }
    }
  }

  /// What is changed at one angle alone is unexplained there and nowhere else.
  void theResidualIsWhereTheDifferenceIs() {
    const auto table = glossyTable();
    PdvFactors factors = factorizePdv(*table, {.form = PdvForm::threeFactors, .terms = terms}).factors;
    const auto before = residualsAlong(*table, factors);
    constexpr std::size_t changed = 30;
    for (auto& channel : factors.channels) channel[0].f1[changed] *= 2;
    const auto after = residualsAlong(*table, factors);
    for (std::size_t i = 0; i < factors.thetaNodes.size(); ++i)
      if (i == changed)
        QVERIFY(after[terms - 1][0][i] > before[terms - 1][0][i] + 0.5);
      else
        QCOMPARE(after[terms - 1][0][i], before[terms - 1][0][i]);
  }

  void aBlackMaterialLeavesNothing() {
    const HalfDifferenceGrid grid{.thetaHCount = 8, .thetaDCount = 8, .phiDCount = 8};
    const TabulatedBrdf black(grid, std::vector<TabulatedBrdf::Value>(grid.size()),
                              std::vector<std::uint8_t>(grid.size(), 1));
    const auto along = residualsAlong(black, factorizePdv(black, {.terms = 1}).factors);
    for (const auto& axis : along[0])
      for (const double fraction : axis) QCOMPARE(fraction, 0.0);
  }
};

GONIO_TEST(PdvResidualsTest)
}  // namespace pdv_residuals_test

#include "pdv_residuals_test.moc"
