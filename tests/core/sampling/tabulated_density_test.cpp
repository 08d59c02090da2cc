// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/sampling/tabulated_density.h"

#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/brdf/tabulated_brdf.h"
#include "core/math/sampling.h"
#include "core/models/model.h"
#include "tests/support/function_brdf.h"
#include "tests/support/sampling_check.h"
#include "tests/support/spiky_table.h"
#include "tests/support/test_program.h"

namespace tabulated_density_test {
using namespace gonio;

std::shared_ptr<const Brdf> model(const char* id) {
  const models::Model& found = models::findModel(id);
  return found.instantiate(models::defaultParameters(found.spec()));
}

/// A BRDF that draws by a tabulated density of another one.
class Sampled final : public Brdf {
 public:
  explicit Sampled(const Brdf& brdf) : density_(brdf) {}
  void evaluate(std::span<const DirectionPair>, std::span<Rgb>) const override {}
  bool hasImportanceSampling() const override { return true; }
  DirectionSample sample(const Direction& wo, const glm::dvec3& u) const override {
    return tabulatedMixture(density_).sample(wo, u);
  }
  double pdf(const Direction& wi, const Direction& wo) const override { return tabulatedMixture(density_).pdf(wi, wo); }

 private:
  TabulatedDensity density_;
};

constexpr double tolerance = 1e-5;

class TabulatedDensityTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void samplesFollowTheDensity_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<double>("theta");
    for (const char* id : {"lambert", "ggx", "ward-duer"})
      for (const double theta : {0.0, 25.0, 60.0, 84.0})
        QTest::newRow((std::string(id) + " " + std::to_string(int(theta))).c_str()) << QString(id) << radians(theta);
  }
  void samplesFollowTheDensity() {
    QFETCH(QString, id);
    QFETCH(double, theta);
    const Sampled sampled(*model(id.toLatin1().data()));
    const int draws = theta == radians(25.0) ? 1 << 20 : 1 << 17;
    const auto check = test::checkSampling(sampled, fromSpherical(theta, 0.7), draws, tolerance);
    const QByteArray found = "integral " + QByteArray::number(check.integral, 'g', 8) + ", lost " +
                             QByteArray::number(check.lost) + ", p " + QByteArray::number(check.pValue);
    QVERIFY2(check.valid, found);
    QVERIFY2(check.lost < 0.02, found);
    QVERIFY2(std::abs(check.integral + check.lost - 1) < 2e-3, found);
    QVERIFY2(check.pValue > 1e-4, found);
    if (draws == 1 << 20) QVERIFY2(check.widerPValue < 1e-9, found);
  }

  /// The estimate of an albedo is that of the quadrature, with less noise than cosine-weighted directions have.
  void estimatesAreUnbiased() {
    const auto brdf = model("ggx");
    const TabulatedDensity density(*brdf);
    for (const double theta : {0.1, 0.9, 1.4}) {
      const Direction wo = fromSpherical(theta, 2);
      double sum = 0, squares = 0, plain = 0, plainSquares = 0;
      constexpr int count = 1 << 16;
      for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 u = scrambledSobol(i, 5);
        const glm::dvec3 numbers(scrambledVanDerCorput(i, 6), u);
        const DirectionSample drawn = tabulatedMixture(density).sample(wo, numbers),
                              even = cosineSampler().sample(wo, numbers);
        const double estimate = drawn.pdf > 0 ? brdf->evaluate(drawn.wi, wo).x * drawn.wi.z / drawn.pdf : 0;
        const double other = brdf->evaluate(even.wi, wo).x * even.wi.z / even.pdf;
        sum += estimate / count, squares += estimate * estimate / count;
        plain += other / count, plainSquares += other * other / count;
      }
      QVERIFY(std::abs(sum / plain - 1) < 0.02);
      QVERIFY(squares - sum * sum < 0.25 * (plainSquares - plain * plain));
    }
  }

  /// A surface that one round density follows is drawn from it; one with two highlights from the table.
  void aRoundDensityServesWhereItFollows() {
    const TabulatedDensity round(*test::ggx(Rgb(0.1), Rgb(1), 0.2, 0.5));
    QVERIFY(round.symmetricDensity() && std::abs(std::log(round.symmetricDensity()->roughness / 0.2)) < 0.4);
    const auto narrow = test::ggx(Rgb(0), Rgb(0.5), 0.02, 0.9), wide = test::ggx(Rgb(0), Rgb(0.5), 0.35, 0.9);
    const test::FunctionBrdf two(
        [&](const Direction& wi, const Direction& wo) { return narrow->evaluate(wi, wo) + wide->evaluate(wi, wo); });
    const TabulatedDensity table(two);
    QVERIFY(!table.symmetricDensity());
    QVERIFY(!areSimilar(round, table) && !areSimilar(table, round));
    QVERIFY(areSimilar(round, TabulatedDensity(*test::ggx(Rgb(0.1), Rgb(0.95), 0.2, 0.5))));
    QVERIFY(!areSimilar(round, TabulatedDensity(*test::ggx(Rgb(0.1), Rgb(1), 0.05, 0.5))));
  }

  /// A spike of one cell: samples find it, and no sample weighs far more than the mean.
  void hardCase53SpikeOfOneCell_data() {
    QTest::addColumn<int>("thetaH");
    QTest::addColumn<int>("thetaD");
    QTest::addColumn<int>("phiD");
    QTest::addColumn<double>("viewer");
    QTest::newRow("at the normal") << 0 << 0 << -1 << 0.3;
    QTest::newRow("mirror pairs at 20 degrees") << 0 << 20 << -1 << 20.0;
    QTest::newRow("off the highlight") << 40 << 30 << -1 << 35.0;
    QTest::newRow("off the highlight, one azimuth") << 40 << 30 << 45 << 44.2;
  }
  void hardCase53SpikeOfOneCell() {
    QFETCH(int, thetaH);
    QFETCH(int, thetaD);
    QFETCH(int, phiD);
    QFETCH(double, viewer);
    const auto table = test::spikyTable(thetaH, thetaD, phiD, 1e6f);
    const TabulatedDensity density(*table);
    QVERIFY(!density.symmetricDensity());
    const Direction wo = fromSpherical(radians(viewer), 0);
    const double expected = test::albedoOfSpike(*table, radians(viewer), std::max(0, thetaH - 1), thetaH + 1);
    constexpr int count = 1 << 18;
    double sum = 0, squares = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
      const DirectionSample drawn =
          tabulatedMixture(density).sample(wo, glm::dvec3(scrambledVanDerCorput(i, 8), scrambledSobol(i, 7)));
      const double estimate = drawn.pdf > 0 ? table->evaluate(drawn.wi, wo).x * drawn.wi.z / drawn.pdf : 0;
      sum += estimate / count, squares += estimate * estimate / count;
    }
    const QByteArray found = QByteArray::number(sum) + ", expected " + QByteArray::number(expected) +
                             ", second moment " + QByteArray::number(squares / (expected * expected));
    QVERIFY2(std::abs(sum / expected - 1) < 0.1, found);
    QVERIFY2(squares < 600 * expected * expected, found);
  }

  /// A table of zeros: cosine-weighted directions, for every viewer; one that is black for some viewers alone:
  /// densities of the size of cos theta / pi, and few failures.
  void hardCase40BlackIsCosine() {
    const auto black = test::spikyTable(0, 0, -1, 0, 0);
    const TabulatedDensity nothing(*black);
    QVERIFY(nothing.symmetricDensity());
    const test::FunctionBrdf grazing([](const Direction&, const Direction& wo) { return Rgb(wo.z < 0.3 ? 0.2 : 0.0); });
    const TabulatedDensity some(grazing);
    for (const double theta : {0.0, 0.5, 1.1, halfPi - 1e-9}) {
      const Direction wo = fromSpherical(theta, 0.4);
      int failures = 0;
      constexpr int count = 4096;
      for (std::uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 u(scrambledVanDerCorput(i, 6), scrambledSobol(i, 5));
        const DirectionSample drawn = nothing.symmetricDensity()->sample(wo, u);
        QVERIFY(drawn.wi.z > 0 && std::abs(drawn.pdf - drawn.wi.z / pi) < 1e-12);
        QCOMPARE(nothing.symmetricDensity()->pdf(drawn.wi, wo), drawn.pdf);
        const DirectionSample other = tabulatedMixture(some).sample(wo, u);
        if (!(other.pdf > 0))
          ++failures;
        else
          QVERIFY2(other.pdf < 10, qPrintable(QString("%1 at %2").arg(other.pdf).arg(theta)));
      }
      QVERIFY2(failures < count / 50, qPrintable(QString::number(failures)));
    }
  }

  /// Nothing reflected, or a single needle: still a density.
  void hardCases() {
    const test::FunctionBrdf black([](const Direction&, const Direction&) { return Rgb(0); });
    const Sampled nothing(black);
    for (const double theta : {0.0, 1.0, halfPi - 1e-9}) {
      const auto drawn = nothing.sample(fromSpherical(theta, 1), {0.5, 0.3, 0.7});
      QVERIFY(std::isfinite(drawn.pdf) && drawn.pdf >= 0);
    }
    const test::FunctionBrdf needle(
        [](const Direction& wi, const Direction& wo) { return Rgb(glm::normalize(wi + wo).z > 1 - 1e-12 ? 1e30 : 0); });
    const Sampled sharp(needle);
    const auto drawn = sharp.sample(fromSpherical(0.5, 1), {0.5, 0.3, 0.7});
    QVERIFY(std::isfinite(drawn.pdf) && drawn.pdf >= 0);
  }
};

GONIO_TEST(TabulatedDensityTest)
}  // namespace tabulated_density_test

#include "tabulated_density_test.moc"
