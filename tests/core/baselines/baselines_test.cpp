// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/baselines/baselines.h"

#include <QTest>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "core/baselines/bivariate.h"
#include "core/baselines/gaussian_process.h"
#include "core/baselines/half_difference_tensor.h"
#include "core/baselines/half_vector_sampler.h"
#include "core/baselines/kautz_mccool.h"
#include "core/factorization/half_difference_samples.h"
#include "core/metrics/brdf_metrics.h"
#include "core/support/error.h"
#include "tests/support/function_brdf.h"
#include "tests/support/test_program.h"

namespace baselines_test {
using namespace gonio;
using namespace gonio::factorization;
using namespace gonio::baselines;

const HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 45, .phiDCount = 60};

/// A form that holds a curve exactly: of theta_d, of the viewer's polar angle, of both polar angles, or of microfacets.
enum class Form { none, difference, viewer, product, microfacets };

class BaselinesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    glossy_ = bakeTable(*test::ggx(Rgb(0.3, 0.1, 0.05), Rgb(1), 0.3, 0.05), smallGrid);
    for (double albedo = 0.1; albedo < 2; albedo += 0.1)
      lambertian_ = std::max(lambertian_, metrics::brdfSignalToNoiseRatio(*glossy_, test::lambert(Rgb(albedo))));
  }

  /// From the table to the BRDF, a baseline reproduces what its form holds, within what it loses between its nodes: a
  /// coloured Lambertian, and a curve of an angle of its own axes. (Left out are Lawrence et al., whose products of
  /// curves have to be 0 for light below the horizon.)
  void reproducesWhatItsFormHolds_data() {
    QTest::addColumn<Form>("form");
    const std::map<std::string_view, Form> others{{"lawrence", Form::none},
                                                  {"nonparametric", Form::microfacets},
                                                  {"bilgili", Form::viewer},
                                                  {"bilgili-luminance", Form::viewer},
                                                  {"mccool", Form::product}};
    for (const Baseline& baseline : allBaselines()) {
      const auto other = others.find(baseline.id);
      const Form form = other == others.end() ? Form::difference : other->second;
      if (form != Form::none) QTest::newRow(baseline.id.data()) << form;
    }
  }
  void reproducesWhatItsFormHolds() {
    QFETCH(Form, form);
    const double constant = worstOf(test::lambert(Rgb(0.6, 0.3, 0.1)));
    QVERIFY2(constant < 3e-3, qPrintable(QString::number(constant)));
    if (form == Form::microfacets) return;  // withinItsBudget() has its curves
    const auto curve = [](double cosine) { return 0.1 + 0.2 * cosine * cosine; };
    const test::FunctionBrdf material(
        [&](const Direction& wi, const Direction& wo) {
          return Rgb(form == Form::viewer    ? curve(wo.z)
                     : form == Form::product ? curve(wi.z) * curve(wo.z)
                                             : curve(std::cos(toHalfDifference(wi, wo).thetaD)));
        },
        true, form != Form::viewer);
    const double worst = worstOf(material);
    QVERIFY2(worst < 1e-2, qPrintable(QString::number(worst)));
  }

  /// A glossy material is represented within the budget, without negative values, better than by any grey Lambertian,
  /// and no worse with a larger budget. It is of the form of Bagher et al.: that has an error of less than 0.32 % (50
  /// dB). Lawrence et al., which reproducesWhatItsFormHolds() leaves out, have a mark instead. (docs/results/factors.md
  /// compares the others.)
  void withinItsBudget_data() {
    QTest::addColumn<double>("small");
    QTest::addColumn<double>("large");
    for (const Baseline& baseline : allBaselines()) {
      const double small = baseline.id == "nonparametric" ? 50 : lambertian_;
      QTest::newRow(baseline.id.data()) << small << (baseline.id == "lawrence" ? 20.3 : small);
    }
  }
  void withinItsBudget() {
    QFETCH(double, small);
    QFETCH(double, large);
    const std::vector<std::size_t> budgets = {4'000, 20'000};
    const std::vector<ComparedModel> models = findBaseline(QTest::currentDataTag()).build(*glossy_, budgets, {});
    QCOMPARE(models.size(), std::size_t(2));
    QVERIFY(models[0].bytes > 0 && models[0].bytes <= budgets[0]);
    QVERIFY(models[1].bytes >= models[0].bytes && models[1].bytes <= budgets[1]);
    const double few = metrics::brdfSignalToNoiseRatio(*glossy_, *models[0].brdf),
                 many = metrics::brdfSignalToNoiseRatio(*glossy_, *models[1].brdf);
    QVERIFY2(few > small && many > large && many >= few, qPrintable(QString("%1 %2").arg(few).arg(many)));
    std::mt19937_64 generator(5);
    for (int i = 0; i < 3000; ++i) {
      const Rgb value = models[1].brdf->evaluate(test::randomUpper(generator), test::randomUpper(generator));
      for (int c = 0; c < 3; ++c) QVERIFY(std::isfinite(value[c]) && value[c] >= 0);
    }
    QCOMPARE(models[1].brdf->evaluate({0, 0, -1}, {0, 0, 1}), Rgb(0));
  }

  void hardCase12BlackTable() {
    const auto black = bakeTable(test::lambert(Rgb(0)), smallGrid);
    const std::vector<std::size_t> budgets = {5000};
    for (const Baseline& baseline : allBaselines()) {
      const Rgb value = baseline.build(*black, budgets, {})[0].brdf->evaluate({0, 0.6, 0.8}, {0.6, 0, 0.8});
      QVERIFY2(maxChannel(value) < 1e-4, baseline.id.data());
    }
  }

  void named() {
    std::set<std::string_view> ids;
    for (const Baseline& baseline : allBaselines()) {
      ids.insert(baseline.id);
      QVERIFY(!baseline.name.empty() && !baseline.reference.empty());
    }
    QCOMPARE(ids.size(), allBaselines().size());
    for (const Baseline& baseline : allBaselines()) QVERIFY(&findBaseline(baseline.id) == &baseline);
    try {
      findBaseline("tucker");
      QFAIL("accepted");
    } catch (const Error& error) {
      QVERIFY(std::string(error.what()).find("'tucker', expected one of kautz-mccool, mccool") != std::string::npos);
    }
  }

  /// maxBytes are the sizes for an unlimited budget.
  void maxBytesAreThoseOfTheLargestModels() {
    constexpr std::size_t endless = 1'000'000'000;
    const HalfDifferenceAxes axes = kautzMcCoolAxes();
    const auto matrixBytes = std::size_t(kautzMcCoolTerms(axes, endless)) *
                             (3 * axes.thetaH.size() + axes.thetaD.size() * axes.phiD.size()) * sizeof(float);
    QCOMPARE(findBaseline("kautz-mccool").maxBytes, matrixBytes);
    QCOMPARE(findBaseline("nmf").maxBytes, matrixBytes);
    QCOMPARE(findBaseline("bivariate").maxBytes, std::size_t(std::pow(bivariateSide(endless), 2)) * 3 * sizeof(float));
    const auto black = sampleHalfDifferenceTensor(emptySamples(axes));
    QCOMPARE(findBaseline("gaussian-process").maxBytes, std::size_t(24 * (maxGaussianNodes + 1)));
    QCOMPARE(findBaseline("cp").maxBytes, decomposeCp(black, cpTerms(axes, endless)).bytes);
    QCOMPARE(findBaseline("hosvd").maxBytes, decomposeHosvd(black, hosvdRanks(axes, endless)).bytes);
    for (const char* id : {"mccool", "nonparametric"}) QCOMPARE(findBaseline(id).maxBytes, std::size_t(0));
  }

  /// Half-out samples are the table's values; the measure integrates to 1/2 for the viewer's polar angle times pi / 2
  /// for the half of the hemisphere that the azimuths cover.
  void halfOutSamplesOfALambertian() {
    const auto table = bakeTable(test::lambert(Rgb(1)), smallGrid);
    const HalfOutSamples s = sampleHalfOut(*table, makeHalfOutAxes(90, 60, 45));
    double sum = 0;
    for (std::size_t h = 0; h < s.axes.thetaH.size(); ++h)
      for (std::size_t p = 0; p < s.axes.phiH.size(); ++p)
        for (std::size_t o = 0; o < s.axes.thetaO.size(); ++o) {
          const std::size_t i = s.axes.index(h, p, o);
          if (s.valid[i]) QVERIFY(std::abs(s.values[i].x - 1 / pi) < 1e-6);
          sum += projectedMeasure(s, h, p, o);
        }
    QVERIFY2(std::abs(sum / (pi / 4) - 1) < 0.02, qPrintable(QString::number(sum / (pi / 4))));
  }

  /// Half-difference samples are the table's values; the measure integrates to that of both projected solid angles,
  /// pi^2, over a quarter of phi_d, a unit of phi_h, and the factor 4 that it leaves out.
  void halfDifferenceSamplesOfALambertian() {
    const auto table = bakeTable(test::lambert(Rgb(1)), smallGrid);
    const HalfDifferenceSamples s = sampleHalfDifference(*table, makeHalfDifferenceAxes(90, 90, 19));
    double sum = 0;
    for (std::size_t h = 0; h < 90; ++h)
      for (std::size_t d = 0; d < 90; ++d)
        for (std::size_t p = 0; p < 19; ++p) {
          if (const std::size_t i = s.axes.index(h, d, p); s.valid[i]) QVERIFY(std::abs(s.values[i].x - 1 / pi) < 1e-6);
          sum += projectedMeasure(s, h, d, p);
        }
    QVERIFY2(std::abs(sum / (pi / 32) - 1) < 0.01, qPrintable(QString::number(sum / (pi / 32))));
  }

  /// The mean of four azimuths, of a function that has no symmetry: what is odd goes.
  void halfDifferenceSamplesAreSymmetric() {
    const auto table = bakeTable(test::FunctionBrdf([](const Direction& wi, const Direction& wo) {
                                   const HalfDifference at = toHalfDifference(wi, wo);
                                   return Rgb(2 + std::sin(2 * at.phiD) + at.thetaH + std::cos(2 * at.phiD));
                                 }),
                                 {.thetaHCount = 30, .thetaDCount = 30, .phiDCount = 180});
    const HalfDifferenceAxes axes = makeHalfDifferenceAxes(30, 30, 7);
    const HalfDifferenceSamples s = sampleHalfDifference(*table, axes);
    for (std::size_t h = 1; h < 10; ++h)
      for (std::size_t d = 3; d < 15; ++d)
        for (std::size_t p = 0; p < 7; ++p)
          QVERIFY(std::abs(s.values[axes.index(h, d, p)].x - (2 + axes.thetaH[h] + std::cos(2 * axes.phiD[p]))) < 0.01);
  }

 private:
  /// The largest relative error that the baseline of this row has within 4,000 bytes, not near the horizon.
  double worstOf(const Brdf& material) {
    HalfDifferenceGrid grid = smallGrid;
    grid.reciprocal = material.isReciprocal();
    if (!grid.reciprocal) grid.phiDCount *= 2;
    const std::vector<std::size_t> budgets = {4'000};
    const auto model = findBaseline(QTest::currentDataTag()).build(*bakeTable(material, grid), budgets, {})[0].brdf;
    std::mt19937_64 generator(6);
    double largest = 0;
    for (int i = 0; i < 3000; ++i) {
      const Direction wi = test::randomUpper(generator), wo = test::randomUpper(generator);
      if (std::min(wi.z, wo.z) < 0.2) continue;
      largest = std::max(largest, maxChannel(glm::abs(model->evaluate(wi, wo) / material.evaluate(wi, wo) - 1.0)));
    }
    return largest;
  }

  std::shared_ptr<const TabulatedBrdf> glossy_;
  double lambertian_ = 0;  ///< SNR of the best grey Lambertian for `glossy_`, dB
};

GONIO_TEST(BaselinesTest)
}  // namespace baselines_test

#include "baselines_test.moc"
