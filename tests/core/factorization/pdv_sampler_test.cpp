// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_sampler.h"

#include <QTest>
#include <cmath>
#include <random>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/pdv_factors.h"
#include "core/math/quadrature.h"
#include "tests/support/function_brdf.h"
#include "tests/support/sampling_check.h"

using namespace gonio;
using namespace gonio::factorization;

namespace {

/// Angles of the viewer of hard case 41, degrees, and what the printed scheme keeps there of its draws.
constexpr double anglesDegrees[] = {0, 30, 60, 75, 85, 89.9};
constexpr double keptByPrinted[] = {1, 0.869, 0.693, 0.527, 0.428, 0.415};

double abcLobe(double deviation) { return 0.02 + 50 / std::pow(1 + 400 * deviation * deviation, 1.2); }

gonio::testing::FunctionBrdf abcBrdf() {
  return gonio::testing::FunctionBrdf(
      [](const Direction& wi, const Direction& wo) { return Rgb(abcLobe(toProjectedDeviation(wi, wo).deviation)); });
}

std::vector<double> nodesTo(double last, int count, double power) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * std::pow(double(i) / (count - 1), power));
  return nodes;
}
const std::vector<double> thetas = nodesTo(radians(89), 90, 1), deviations = nodesTo(2, 90, 2);

/// A sampler as what the checks of sampling work on.
template <typename Sampler>
class SampledBrdf final : public Brdf {
 public:
  explicit SampledBrdf(Sampler sampler) : sampler_(std::move(sampler)) {}
  using Brdf::evaluate;
  void evaluate(std::span<const DirectionPair>, std::span<Rgb> values) const override {
    std::fill(values.begin(), values.end(), Rgb(0));
  }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override { return sampler_.sample(wo, u); }
  double pdf(const Direction& wi, const Direction& wo) const override { return sampler_.pdf(wi, wo); }

 private:
  Sampler sampler_;
};

/// Integral over the hemisphere in the coordinates of the disk, bin by bin: exact to 1e-7 where the bins are smooth.
template <typename Sampler>
double integral(const Sampler& sampler, double thetaR, const std::vector<double>& edges) {
  static const QuadratureRule rule = gaussLegendre(12, 0, 1);
  const double sine = std::sin(thetaR);
  const Direction wo = fromSpherical(thetaR, 0);
  double sum = 0;
  for (std::size_t bin = 0; bin + 1 < edges.size() && edges[bin] < 1 + sine; ++bin) {
    // The kink where the circle meets the rim is a border too.
    std::vector<double> borders{edges[bin], std::min(edges[bin + 1], 1 + sine)};
    if (1 - sine > borders[0] && 1 - sine < borders[1]) borders.insert(borders.begin() + 1, 1 - sine);
    for (std::size_t part = 0; part + 1 < borders.size(); ++part)
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        // Toward both ends the limit of the azimuth goes as a square root.
        const double t = rule.nodes[i], ease = t * t * (3 - 2 * t), width = borders[part + 1] - borders[part];
        const double deviation = borders[part] + width * ease, limit = azimuthLimit(deviation, sine);
        for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
          const auto at = fromProjectedDeviation({thetaR, deviation, limit * rule.nodes[k]});
          if (!(at.pair.wi.z > 0)) continue;
          sum += rule.weights[i] * 6 * t * (1 - t) * width * rule.weights[k] * 2 * limit * deviation / at.pair.wi.z *
                 sampler.pdf(at.pair.wi, wo);
        }
      }
  }
  return sum;
}

}  // namespace

class PdvSamplerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void hardCase41DensitiesIntegrateToOne() {
    const PdvSampler sampler(abcBrdf(), thetas, deviations);
    for (const double angle : anglesDegrees) {
      const double total = integral(sampler, radians(angle), deviations);
      QVERIFY2(std::abs(total - 1) < 1e-4, qPrintable(QString("%1 degrees: %2").arg(angle).arg(total, 0, 'g', 8)));
    }
  }

  /// Where draws fall, against the integrals of the density, and the promises on each draw. (The check's own integral
  /// overlooks steps that lie between its points: the test above has it exactly.)
  void hardCase41DrawsFollowTheDensity_data() {
    QTest::addColumn<double>("angle");
    for (const double angle : anglesDegrees) QTest::addRow("%g degrees", angle) << angle;
  }
  void hardCase41DrawsFollowTheDensity() {
    QFETCH(double, angle);
    const SampledBrdf brdf(PdvSampler(abcBrdf(), thetas, deviations));
    const tests::SamplingCheck check = tests::checkSampling(brdf, fromSpherical(radians(angle), 0.7));
    QVERIFY(check.valid);
    QVERIFY2(std::abs(check.integral - 1) < 1e-3, qPrintable(QString::number(check.integral, 'g', 8)));
    QVERIFY2(check.pValue > 1e-3, qPrintable(QString::number(check.pValue)));
  }

  /// The printed scheme loses what the errata of the dissertation say; of the draws themselves, too.
  void printedSchemeLosesDraws() {
    const PrintedPdvSampler sampler(abcBrdf(), thetas, deviations);
    for (std::size_t n = 0; n < std::size(anglesDegrees); ++n) {
      const double thetaR = radians(anglesDegrees[n]), total = integral(sampler, thetaR, deviations);
      QVERIFY2(std::abs(total - keptByPrinted[n]) < 3e-3,
               qPrintable(QString("%1 degrees: %2").arg(anglesDegrees[n]).arg(total)));
      std::mt19937_64 random(3);
      std::uniform_real_distribution<double> uniform(0, 1);
      constexpr int draws = 20000;
      int kept = 0;
      for (int i = 0; i < draws; ++i) {
        const double a = uniform(random), b = uniform(random), c = uniform(random);
        kept += sampler.sample(fromSpherical(thetaR, 1), {a, b, c}).pdf > 0;
      }
      QVERIFY(std::abs(double(kept) / draws - total) < 0.02);
    }
  }

  /// The density is that of the lobe: nine tenths of rho~ cos / Z with Z by quadrature, and a tenth of cos / pi.
  void theDensityIsTheLobes() {
    const PdvSampler sampler(abcBrdf(), thetas, deviations);
    const QuadratureRule rule = gaussLegendre(4000, 0, 1);
    for (const double angle : {0.0, 40.0, 70.0}) {
      const double thetaR = radians(angle), sine = std::sin(thetaR);
      double z = 0;
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double deviation = (1 + sine) * rule.nodes[i];
        z += (1 + sine) * rule.weights[i] * abcLobe(deviation) * deviation * 2 * azimuthLimit(deviation, sine);
      }
      for (const double deviation : {0.0, 0.02, 0.1, 0.3}) {
        const auto at = fromProjectedDeviation({thetaR, deviation, 0.5});
        const double expected = at.pair.wi.z * (0.9 * abcLobe(deviation) / z + 0.1 / pi);
        const double found = sampler.pdf(at.pair.wi, at.pair.wo);
        QVERIFY2(std::abs(found / expected - 1) < 0.12,
                 qPrintable(QString("%1 %2: %3 %4").arg(angle).arg(deviation).arg(found).arg(expected)));
      }
    }
  }

  /// hardCase07: no 0/0 at the mirror direction.
  void hardCase07MirrorDirection() {
    const PdvSampler sampler(abcBrdf(), thetas, deviations);
    for (const double angle : anglesDegrees) {
      const Direction wo = fromSpherical(radians(angle), 0), mirror(-wo.x, -wo.y, wo.z);
      const auto beside = fromProjectedDeviation({radians(angle), 1e-9, 1});
      // By their cosines, which fall steeply at the horizon.
      const double there = sampler.pdf(mirror, wo) / mirror.z;
      const double limit = sampler.pdf(beside.pair.wi, wo) / beside.pair.wi.z;
      QVERIFY(std::isfinite(there) && there > 0);
      QVERIFY2(std::abs(there / limit - 1) < 1e-5, QByteArray::number(there / limit, 'g', 10));
    }
  }

  void hardCase40BlackIsCosine() {
    const PdvSampler black(gonio::testing::lambert(Rgb(0)), thetas, deviations);
    const Direction wo = fromSpherical(1, 2);
    for (const double u : {0.0, 0.5, 1 - 0x1p-24}) {
      const DirectionSample sample = black.sample(wo, {u, 0.3, 0.6});
      QVERIFY(std::abs(sample.pdf - sample.wi.z / pi) < 1e-12);
    }
    // Black for steep viewers only: between a black row and one that is not, the cosine has its part.
    const gonio::testing::FunctionBrdf half(
        [](const Direction&, const Direction& o) { return Rgb(o.z < 0.5 ? 1 : 0); });
    const PdvSampler sampler(half, thetas, deviations);
    for (const double angle : {0.5, 59.9, 60.3, 60.9, 61.5, 80.0})
      QVERIFY(std::abs(integral(sampler, radians(angle), deviations) - 1) < 1e-4);
  }

  /// hardCase40: energy in one bin only: drawn from it alone, finite, for the largest numbers too.
  void hardCase40OneBin() {
    const double low = deviations[20], high = deviations[21];
    const gonio::testing::FunctionBrdf ring([=](const Direction& wi, const Direction& wo) {
      const double deviation = toProjectedDeviation(wi, wo).deviation;
      return Rgb(deviation >= low && deviation < high ? 1 : 0);
    });
    const PdvSampler sampler(ring, thetas, deviations);
    for (const double u : {0.11, 0.5, 1 - 0x1p-24, 1 - 0x1p-53})
      for (const double v : {0.0, 0.5, 1 - 0x1p-53}) {
        const Direction wo = fromSpherical(0.4, 0);
        const DirectionSample sample = sampler.sample(wo, {u, v, 0.25});
        const double deviation = toProjectedDeviation(sample.wi, wo).deviation;
        QVERIFY(deviation > low - 1e-9 && deviation < high + 1e-9);
        QVERIFY(std::isfinite(sample.pdf) && sample.pdf > 0 && sample.wi.z > 0);
      }
  }

  void belowTheHorizonItIsZero() {
    const PdvSampler sampler(abcBrdf(), thetas, deviations);
    QCOMPARE(sampler.pdf(fromSpherical(2, 0), fromSpherical(0.5, 1)), 0.0);
    QCOMPARE(sampler.pdf(fromSpherical(halfPi, 0), Direction(0, 0, 1)) < 1e-9, true);
  }

  /// The BRDF of factors draws by its own first term.
  void factorsDrawByTheirFirstTerm() {
    const auto source = gonio::testing::ggx(Rgb(0.1), Rgb(1), 0.15, 0.5);
    const HalfDifferenceGrid grid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};
    const PdvFactors factors = factorizePdv(*bakeTable(*source, grid), {.terms = 2}).factors;
    const auto brdf = makePdvBrdf(factors), first = makePdvBrdf(factors.truncated(1));
    const Direction wo = fromSpherical(0.8, 0.3);
    for (const double u : {0.05, 0.3, 0.7}) {
      const DirectionSample sample = brdf->sample(wo, {u, 0.4, 0.9}), expected = first->sample(wo, {u, 0.4, 0.9});
      QCOMPARE(sample.pdf, expected.pdf);
      QVERIFY(sample.wi == expected.wi);
      QCOMPARE(brdf->pdf(sample.wi, wo), sample.pdf);
    }
  }
};

QTEST_APPLESS_MAIN(PdvSamplerTest)
#include "pdv_sampler_test.moc"
