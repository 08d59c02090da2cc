// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/factorization/pdv_brdf.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/coordinates/projected_deviation.h"
#include "core/factorization/pdv_factors.h"
#include "core/math/quadrature.h"
#include "tests/support/function_brdf.h"
#include "tests/support/sampling_check.h"
#include "tests/support/test_program.h"

namespace pdv_sampler_test {
using namespace gonio;
using namespace gonio::factorization;

/// Polar angles of the viewer up to grazing, degrees, and the fraction of samples that the printed scheme keeps.
constexpr double anglesDegrees[] = {0, 30, 60, 75, 85, 89.9};
constexpr double keptByPrinted[] = {1, 0.869, 0.693, 0.527, 0.428, 0.415};

double abcLobe(double deviation) { return 0.02 + 50 / std::pow(1 + 400 * deviation * deviation, 1.2); }

gonio::test::FunctionBrdf abcBrdf() {
  return gonio::test::FunctionBrdf(
      [](const Direction& wi, const Direction& wo) { return Rgb(abcLobe(toProjectedDeviation(wi, wo).deviation)); });
}

std::vector<double> nodesTo(double last, int count, double power) {
  std::vector<double> nodes;
  for (int i = 0; i < count; ++i) nodes.push_back(last * std::pow(double(i) / (count - 1), power));
  return nodes;
}
const std::vector<double> thetas = nodesTo(radians(89), 90, 1), deviations = nodesTo(2, 90, 2);

/// Parts of the azimuths, from minus the limit to the limit, of each bin.
constexpr std::size_t sectors = 4;

/// Integral over the part [from, to] of the azimuths of the deviations [low, high].
template <typename Sampler>
double integralOver(const Sampler& sampler, double thetaR, double low, double high, double from, double to) {
  static const QuadratureRule rule = gaussLegendre(12, 0, 1);
  const double sine = std::sin(thetaR), width = high - low;
  const Direction wo = fromSpherical(thetaR, 0);
  double sum = 0;
  for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
    // Toward both ends the limit of the azimuth goes as a square root.
    const double t = rule.nodes[i], ease = t * t * (3 - 2 * t), deviation = low + width * ease;
    const double limit = azimuthLimit(deviation, sine);
    for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
      const auto at = fromProjectedDeviation({thetaR, deviation, limit * (from + (to - from) * rule.nodes[k])});
      if (!(at.pair.wi.z > 0)) continue;
      sum += rule.weights[i] * 6 * t * (1 - t) * width * rule.weights[k] * (to - from) * limit * deviation /
             at.pair.wi.z * sampler.pdf(at.pair.wi, wo);
    }
  }
  return sum;
}

/// Integrals of the density over the sectors of each bin, in the coordinates of the disk: exact to 1e-7 where the bins
/// are smooth.
template <typename Sampler>
std::vector<double> integrals(const Sampler& sampler, double thetaR, const std::vector<double>& edges) {
  const double sine = std::sin(thetaR);
  std::vector<double> result((edges.size() - 1) * sectors, 0.0);
  for (std::size_t bin = 0; bin + 1 < edges.size() && edges[bin] < 1 + sine; ++bin) {
    // The kink where the circle meets the rim is a border too.
    std::vector<double> borders{edges[bin], std::min(edges[bin + 1], 1 + sine)};
    if (1 - sine > borders[0] && 1 - sine < borders[1]) borders.insert(borders.begin() + 1, 1 - sine);
    for (std::size_t part = 0; part + 1 < borders.size(); ++part)
      for (std::size_t sector = 0; sector < sectors; ++sector)
        result[bin * sectors + sector] +=
            integralOver(sampler, thetaR, borders[part], borders[part + 1], 2 * double(sector) / sectors - 1,
                         2 * double(sector + 1) / sectors - 1);
  }
  return result;
}

/// With each bin in two, so that draws are seen that are uneven within bins.
std::vector<double> halved(const std::vector<double>& edges) {
  std::vector<double> result{edges.front()};
  for (std::size_t i = 1; i < edges.size(); ++i) {
    result.push_back((edges[i - 1] + edges[i]) / 2);
    result.push_back(edges[i]);
  }
  return result;
}

template <typename Sampler>
double integral(const Sampler& sampler, double thetaR, const std::vector<double>& edges) {
  const std::vector<double> parts = integrals(sampler, thetaR, edges);
  return std::accumulate(parts.begin(), parts.end(), 0.0);
}

/// The sector of a bin in which a direction lies.
std::size_t cellOf(const Direction& wi, const Direction& wo, const std::vector<double>& edges) {
  const ProjectedDeviation at = toProjectedDeviation(wi, wo);
  const auto bin = std::size_t(std::upper_bound(edges.begin(), edges.end(), at.deviation) - edges.begin()) - 1;
  const double fraction = at.phi / azimuthLimit(at.deviation, std::hypot(wo.x, wo.y));
  return bin * sectors + std::size_t(std::clamp((fraction + 1) / 2 * sectors, 0.0, sectors - 1.0));
}

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

  /// Where draws fall, against the integrals of the density, and the promises on each draw. With few nodes the density
  /// falls by much within a bin, and from row to row.
  void hardCase41SamplesFollowTheDensity_data() {
    QTest::addColumn<int>("nodes");
    QTest::addColumn<double>("angle");
    for (const int nodes : {90, 12})
      for (const double angle : anglesDegrees) QTest::addRow("%d nodes, %g degrees", nodes, angle) << nodes << angle;
  }
  void hardCase41SamplesFollowTheDensity() {
    QFETCH(int, nodes);
    QFETCH(double, angle);
    const int draws = angle == 60 ? 1 << 20 : 1 << 17;
    const std::vector<double> bins = nodesTo(2, nodes, 2), edges = halved(bins);
    const PdvSampler sampler(abcBrdf(), nodesTo(radians(89), nodes, 1), bins);
    const Direction wo = fromSpherical(radians(angle), 0.7);
    std::vector<double> expected = integrals(sampler, radians(angle), edges), observed(expected.size(), 0.0),
                        wider = observed;
    for (double& count : expected) count *= draws;
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int n = 0; n < draws; ++n) {
      const double a = uniform(random), b = uniform(random), c = uniform(random);
      const DirectionSample sample = sampler.sample(wo, {a, b, c});
      QVERIFY(sample.wi.z > 0 && std::abs(glm::length(sample.wi) - 1) < 1e-9);
      QVERIFY(std::isfinite(sample.pdf) && sample.pdf > 0 && sample.pdf == sampler.pdf(sample.wi, wo));
      observed[cellOf(sample.wi, wo, edges)] += 1;
      wider[cellOf(test::widened(sample.wi, wo), wo, edges)] += 1;
    }
    const double right = test::pearsonPValue(expected, observed), wrong = test::pearsonPValue(expected, wider);
    const QByteArray found = "p " + QByteArray::number(right) + ", 2 % wider " + QByteArray::number(wrong);
    QVERIFY2(right > 1e-4, found);
    if (draws == 1 << 20) QVERIFY2(wrong < 1e-9, found);
  }

  /// The printed scheme loses what the errata of the dissertation say; of the draws themselves, too.
  void printedSchemeLosesDraws() {
    const PublishedPdvSampler sampler(abcBrdf(), thetas, deviations);
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

  /// At the mirror direction, where |Dp| = 0, the density is the limit of its neighbourhood and no 0/0.
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
    const PdvSampler black(gonio::test::lambert(Rgb(0)), thetas, deviations);
    const Direction wo = fromSpherical(1, 2);
    for (const double u : {0.0, 0.5, 1 - 0x1p-24}) {
      const DirectionSample sample = black.sample(wo, {u, 0.3, 0.6});
      QVERIFY(std::abs(sample.pdf - sample.wi.z / pi) < 1e-12);
    }
    // Black for steep viewers only: between a black row and one that is not, the cosine has its part.
    const gonio::test::FunctionBrdf half([](const Direction&, const Direction& o) { return Rgb(o.z < 0.5 ? 1 : 0); });
    const PdvSampler sampler(half, thetas, deviations);
    for (const double angle : {0.5, 59.9, 60.3, 60.9, 61.5, 80.0})
      QVERIFY(std::abs(integral(sampler, radians(angle), deviations) - 1) < 1e-4);
  }

  /// Energy in one bin only: samples come from it alone, with a finite density, for the largest numbers too.
  void hardCase40OneBin() {
    const double low = deviations[20], high = deviations[21];
    const gonio::test::FunctionBrdf ring([=](const Direction& wi, const Direction& wo) {
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
    const auto source = gonio::test::ggx(Rgb(0.1), Rgb(1), 0.15, 0.5);
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

GONIO_TEST(PdvSamplerTest)
}  // namespace pdv_sampler_test

#include "pdv_sampler_test.moc"
