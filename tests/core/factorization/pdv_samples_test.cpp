// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_samples.h"

#include <QTest>
#include <cmath>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/deviation_grid.h"
#include "tests/support/test_program.h"

namespace pdv_samples_test {
using namespace gonio;
using namespace gonio::factorization;

const HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

TabulatedBrdf constantTable(float value) {
  return {smallGrid, std::vector<glm::vec3>(smallGrid.size(), glm::vec3(value)),
          std::vector<std::uint8_t>(smallGrid.size(), 1)};
}

std::vector<double> evenNodes(int count, double last) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * i / (count - 1));
  return nodes;
}

PdvFactors someAxes(PdvForm form) {
  return {.form = form,
          .thetaNodes = evenNodes(40, maxPolarAngle),
          .deviationNodes = evenNodes(41, maxDeviation),
          .phiNodes = form == PdvForm::twoFactors ? std::vector{0.0} : evenNodes(42, pi)};
}

bool onDisk(const PdvFactors& axes, int i, int j, int k) {
  const auto at = fromProjectedDeviation(
      {axes.thetaNodes[std::size_t(i)], axes.deviationNodes[std::size_t(j)], axes.phiNodes[std::size_t(k)]});
  return at.valid && at.pair.wi.z > std::cos(maxPolarAngle) * (1 - 1e-8);
}

double sum(const std::vector<float>& weights) {
  double result = 0;
  for (const float weight : weights) result += double(weight);
  return result;
}

class PdvSamplesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Of a black material (the slope of ln(1 + rho) is 1) the weights of all viewers and lights add up to
  /// (integral of cos^2 theta d omega)^2 = (2 pi / 3)^2, in units of pi: one azimuth of the viewer stands for all.
  void theWeightsAreProjectedSolidAngles() {
    for (const PdvForm form : {PdvForm::twoFactors, PdvForm::threeFactors}) {
      const PdvSamples samples = samplePdv(constantTable(0), someAxes(form), PdvWeights::projectedSolidAngle);
      const double expected = 4 * pi / 9, found = sum(samples.channels[0].weights);
      QVERIFY2(std::abs(found - expected) < 0.02 * expected, QByteArray::number(found));
    }
  }

  /// The weight grows with the square root of d rho / d y.
  void theWeightsFollowTheSlope() {
    for (const auto& [transform, slope] :
         {std::pair(DataTransform::logPlus, 16.0), std::pair(DataTransform::root, 2 * std::sqrt(15.0)),
          std::pair(DataTransform::none, 1.0)}) {
      PdvFactors axes = someAxes(PdvForm::threeFactors);
      const double black = sum(samplePdv(constantTable(0), axes, PdvWeights::projectedSolidAngle).channels[1].weights);
      axes.transform = transform;
      const double bright =
          sum(samplePdv(constantTable(15), axes, PdvWeights::projectedSolidAngle).channels[1].weights);
      QVERIFY(std::abs(bright / black - std::sqrt(slope)) < 1e-5);
    }
  }

  /// No cell is left free: each has 2e-5 of the mean weight at least. The mirror direction has no area of its own.
  void everyMeasuredCellCounts() {
    const PdvFactors axes = someAxes(PdvForm::threeFactors);
    const PdvSamples samples = samplePdv(constantTable(1), axes, PdvWeights::projectedSolidAngle);
    const MaskedTensor& t = samples.channels[0];
    const double mean = sum(t.weights) / double(samples.cells);
    for (int i = 0; i < 40; ++i)
      for (int j = 0; j < 41; ++j)
        for (int k = 0; k < 42; ++k)
          if (onDisk(axes, i, j, k)) QVERIFY(double(t.weights[t.index(i, j, k)]) > 1.8e-5 * mean);
  }

  /// Where curves are read between a node on the disk and one off it, the latter holds the value of those beside it.
  void cellsBesideTheDiskAreHeld() {
    const PdvFactors axes = someAxes(PdvForm::threeFactors);
    const float y = std::log1p(3.0f);
    for (const PdvWeights weights : {PdvWeights::equal, PdvWeights::projectedSolidAngle}) {
      const PdvSamples samples = samplePdv(constantTable(3), axes, weights);
      const MaskedTensor& t = samples.channels[2];
      std::size_t cells = 0;
      for (int i = 1; i + 1 < t.sizes[0]; ++i)
        for (int j = 1; j + 1 < t.sizes[1]; ++j)
          for (int k = 1; k + 1 < t.sizes[2]; ++k) {
            const std::size_t at = t.index(i, j, k);
            if (onDisk(axes, i, j, k)) {
              QVERIFY(t.weights[at] > 0);
              continue;
            }
            const bool beside = onDisk(axes, i + 1, j - 1, k + 1) || onDisk(axes, i - 1, j - 1, k + 1);
            const bool far = k >= 3 && j >= 3 && !onDisk(axes, i, j - 3, k) && !onDisk(axes, i, j, k - 3);
            if (beside) QVERIFY(t.weights[at] > 0 && t.weights[at] < 0.02 * (weights == PdvWeights::equal ? 1 : 0.01));
            if (beside) QVERIFY(std::abs(t.values[at] - y) < 1e-5f);
            cells += beside;
            if (far) QCOMPARE(t.weights[at], 0.0f);
          }
      QVERIFY(cells > 500);
    }
  }

  void theCellsThatWereMeasuredAreCounted() {
    const PdvFactors axes = someAxes(PdvForm::threeFactors);
    std::size_t expected = 0;
    for (int i = 0; i < 39; ++i)
      for (int j = 0; j < 41; ++j)
        for (int k = 0; k < 42; ++k) expected += onDisk(axes, i, j, k);
    PdvFactors cut = axes;
    cut.thetaNodes.pop_back();
    QCOMPARE(samplePdv(constantTable(1), cut, PdvWeights::equal).cells, expected);
    const TabulatedBrdf nothing(smallGrid, std::vector<glm::vec3>(smallGrid.size()),
                                std::vector<std::uint8_t>(smallGrid.size(), 0));
    const PdvSamples none = samplePdv(nothing, axes, PdvWeights::projectedSolidAngle);
    QCOMPARE(none.cells, std::size_t(0));
    QCOMPARE(sum(none.channels[0].weights), 0.0);
  }
};

GONIO_TEST(PdvSamplesTest)
}  // namespace pdv_samples_test

#include "pdv_samples_test.moc"
