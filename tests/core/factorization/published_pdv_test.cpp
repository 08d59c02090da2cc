// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "core/factorization/pdv_factors.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace published_pdv_test {
using namespace gonio;
using namespace gonio::factorization;

const HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

/// PDV factors with the weights and the grid of the papers.
class PublishedPdvTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// The energy of a constant BRDF at |Dp| is the fraction of the circle that is on the disk, summed over the viewers.
  void energyOfAConstantIsTheAreaOnTheDisk() {
    const std::vector<double> energy = publishedDeviationEnergy(test::lambert(Rgb(pi)));
    QCOMPARE(energy.size(), std::size_t(2000));
    const auto onDisk = [](double deviation) {
      double sum = 0;
      for (int i = 0; i < 30; ++i) sum += azimuthLimit(deviation, std::sin(halfPi * i / 30));
      return sum;
    };
    const auto at = [](std::size_t j) { return (double(j) + 0.5) * maxDeviation / 2000; };
    for (const std::size_t j : {0u, 300u, 900u, 1400u, 1900u}) {
      const double expected = energy[0] * onDisk(at(j)) / onDisk(at(0));
      QVERIFY2(std::abs(energy[j] - expected) <= 1e-9 * energy[0],
               qPrintable(QString("%1: %2 %3").arg(j).arg(energy[j]).arg(expected)));
    }
    // ln(1 + 1) of three channels, over 30 viewers and 8 azimuths.
    QVERIFY(std::abs(energy[0] - 30 * 8 * 3 * std::log(2)) < 0.05 * energy[0]);
    // As printed: rho = 1.
    const std::vector<double> printed = publishedDeviationEnergy(test::lambert(Rgb(pi)), {}, DataTransform::none);
    QVERIFY(std::abs(printed[0] * std::log(2) / energy[0] - 1) < 1e-12);
  }

  void libraryNodesRise_data() {
    QTest::addColumn<int>("energy");
    QTest::newRow("ln(1 + rho)") << int(DataTransform::logPlus);
    QTest::newRow("rho") << int(DataTransform::none);
  }
  void libraryNodesRise() {
    QFETCH(int, energy);
    const std::vector<double> nodes = libraryDeviationNodes(DataTransform(energy));
    QCOMPARE(nodes.size(), std::size_t(defaultDeviations));
    QCOMPARE(nodes.front(), 0.0);
    QVERIFY(std::abs(nodes.back() - maxDeviation) < 1e-8);
    for (std::size_t i = 1; i < nodes.size(); ++i) QVERIFY(nodes[i] > nodes[i - 1]);
    // The first steps, at highlights, are finer than uniform ones.
    QVERIFY(nodes[1] < 0.5 * maxDeviation / (defaultDeviations - 1));
  }

  /// One term over the library's nodes represents a BRDF whose ln(1 + rho) is one curve of |Dp|. For a glossy material,
  /// the residual over equally weighted cells is smaller than that of factors with other weights.
  void optionsAreThoseOfThePapers() {
    const auto curve = test::FunctionBrdf([](const Direction& wi, const Direction& wo) {
      return Rgb(std::expm1(2 * std::exp(-toProjectedDeviation(wi, wo).deviation)));
    });
    const PdvFactorization exact =
        factorizePdv(*bakeTable(curve, smallGrid), publishedPdvOptions(PdvForm::twoFactors, 2));
    QVERIFY(exact.factors.deviationNodes == libraryDeviationNodes());
    QVERIFY(exact.factors.transform == DataTransform::logPlus);
    QCOMPARE(exact.factors.terms(), 2);
    QVERIFY2(exact.residuals[1] < 0.01, qPrintable(QString::number(exact.residuals[1])));
    const auto glossy = bakeTable(*test::ggx(Rgb(0.2), Rgb(1), 0.2, 0.04), smallGrid);
    const PdvOptions published = publishedPdvOptions(PdvForm::twoFactors, 1);
    PdvOptions ours = published;
    ours.weights = PdvWeights::projectedSolidAngle;
    const auto error = [&](const PdvFactors& f) {
      double sum = 0;
      for (std::size_t i = 0; i < f.thetaNodes.size(); ++i)
        for (std::size_t j = 0; j < f.deviationNodes.size(); ++j) {
          double mean = 0, count = 0;
          for (int k = 0; k < 180; ++k) {
            const auto at = fromProjectedDeviation({f.thetaNodes[i], f.deviationNodes[j], pi * k / 179});
            if (!at.valid || at.pair.wi.z < std::cos(maxPolarAngle)) continue;
            mean += std::log1p(glossy->evaluate(at.pair.wi, at.pair.wo).x);
            ++count;
          }
          const PdvTerm& term = f.channels[0][0];
          if (count > 0) sum += count * std::pow(mean / count - term.f1[i] * term.f2[j], 2);
        }
      return sum;
    };
    const double least = error(factorizePdv(*glossy, published).factors),
                 other = error(factorizePdv(*glossy, ours).factors);
    QVERIFY2(least < other, qPrintable(QString("%1 %2").arg(least).arg(other)));
  }
};

GONIO_TEST(PublishedPdvTest)
}  // namespace published_pdv_test

#include "published_pdv_test.moc"
