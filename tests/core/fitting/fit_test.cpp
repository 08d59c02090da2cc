// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/fit.h"

#include <QTest>
#include <random>

#include "core/fitting/fit_parameters.h"
#include "core/fitting/projected_problem.h"
#include "core/math/parallel.h"
#include "tests/support/leading_parameters.h"
#include "tests/support/test_program.h"

namespace fit_test {
using namespace gonio;
using namespace gonio::fitting;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 45, .thetaDCount = 30, .phiDCount = 36};
const Rgb tint(0.9, 0.5, 0.2), body(0.05, 0.2, 0.3);

models::ParameterValues ggxValues(const std::vector<Rgb>& first) {
  return test::leadingParameters(models::findModel("ggx"), first);
}

std::shared_ptr<const TabulatedBrdf> bake(const models::Model& model, const models::ParameterValues& parameters) {
  return bakeTable(*model.instantiate(parameters), smallGrid);
}

std::shared_ptr<const TabulatedBrdf> constantTable(const Rgb& value) {
  std::vector<std::uint8_t> valid(smallGrid.size());
  for (std::size_t i = 0; i < smallGrid.size(); ++i) valid[i] = smallGrid.nodeAboveHorizon(i);
  return std::make_shared<const TabulatedBrdf>(
      smallGrid, std::vector<TabulatedBrdf::Value>(smallGrid.size(), TabulatedBrdf::Value(value)), std::move(valid));
}

/// As a measurement is: no model explains it, with noise.
std::shared_ptr<const TabulatedBrdf> likeMeasured() {
  const models::Model& ggx = models::findModel("ggx");
  const auto sharp = bake(ggx, ggxValues({body, tint, Rgb(0.05), Rgb(0.3), Rgb(0)}));
  const auto broad = bake(ggx, ggxValues({Rgb(0), tint, Rgb(0.5), Rgb(0.04), Rgb(0)}));
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(0.9f, 1.1f);
  std::vector<TabulatedBrdf::Value> sum(smallGrid.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = (sharp->values()[i] + broad->values()[i]) * noise(random);
  return std::make_shared<const TabulatedBrdf>(smallGrid, std::move(sum),
                                               std::vector<std::uint8_t>(sharp->valid().begin(), sharp->valid().end()));
}

void verifyInsideHardRanges(const FitResult& result) {
  models::ParameterValues clamped = result.parameters;
  QVERIFY(models::clampToHardRange(result.model->spec(), clamped).empty());
}

class FitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void knownParametersAreRecovered_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<std::vector<Rgb>>("parameters");
    const auto row = [](const char* name, const char* model, std::vector<Rgb> p) {
      QTest::newRow(name) << QString(model) << std::move(p);
    };
    row("lambert", "lambert", {body});
    row("blinn-phong glossy", "blinn-phong", {body, tint, Rgb(2000), Rgb(0)});
    row("blinn-phong matte", "blinn-phong", {body, tint, Rgb(5), Rgb(0)});
    row("ward glossy", "ward", {body, tint, Rgb(0.02)});
    row("ward matte", "ward", {body, tint, Rgb(0.4)});
    row("oren-nayar", "oren-nayar", {body, Rgb(0.4)});
    row("torrance-sparrow", "torrance-sparrow", {body, tint, Rgb(0.12), Rgb(0.6)});
    row("cook-torrance plastic", "cook-torrance", {body, tint, Rgb(0.1), Rgb(0.04), Rgb(0)});
    row("cook-torrance metal", "cook-torrance", {Rgb(0), tint, Rgb(0.25), Rgb(0.7), Rgb(0)});
    row("ggx mirror", "ggx", {body, tint, Rgb(0.004), Rgb(0.9), Rgb(0)});
    row("ggx plastic", "ggx", {body, tint, Rgb(0.1), Rgb(0.04), Rgb(0)});
    row("ggx rough", "ggx", {body, tint, Rgb(0.8), Rgb(0.3), Rgb(0)});
    row("abc-smooth", "abc-smooth", {body, Rgb(52, 31, 12), Rgb(3000), Rgb(0.9), Rgb(1.8)});
    row("abc", "abc", {body, Rgb(52, 31, 12), Rgb(10482), Rgb(0.82), Rgb(2.24), Rgb(0)});
    row("he", "he", {body, tint, Rgb(0.1), Rgb(2), Rgb(1.8)});
    row("holzschuch-pacanowski", "holzschuch-pacanowski",
        {body, tint, Rgb(0.1), Rgb(0.6), Rgb(0.5), Rgb(30), Rgb(1.5), Rgb(1.8)});
    row("beard-maxwell", "beard-maxwell", {body, tint, tint, Rgb(0.2), Rgb(0.3), Rgb(0.7), Rgb(0.4)});
    row("car-paint", "car-paint",
        {body, tint, Rgb(0.03), Rgb(0.1), tint, Rgb(0.12), Rgb(0.4), tint, Rgb(0.5), Rgb(0.6)});
    row("weidlich-wilkie", "weidlich-wilkie",
        {body, tint, Rgb(0.3), Rgb(0.6), Rgb(1), Rgb(0.05), Rgb(1.5), Rgb(0.2, 0.4, 0.6)});
    // Published row of alum-bronze (Bagher et al. 2012): every channel has its own lobe.
    row("sgd", "sgd",
        {Rgb(0.0478786, 0.0313514, 0.0200638), Rgb(0.0364976, 0.664975, 0.268836), Rgb(0.014832, 0.0300126, 0.0490339),
         Rgb(0.459076, 0.450056, 0.529272), Rgb(6.05524, 0.235756, 0.580647), Rgb(5.05524, 0.182842, 0.476088),
         Rgb(2.60672, 2.97371, 2.7827), Rgb(1.12717e-07, 1.06401e-07, 5.27952e-08), Rgb(47.783, 36.2767, 31.6066),
         Rgb(0.205635, 0.066289, -0.0661091)});
  }
  /// Within 1 %, as the issue asks; the reflectance itself far better. The four numbers of SGD's shadowing are not
  /// compared: different ones give the same curve, and with it the same reflectance.
  void knownParametersAreRecovered() {
    QFETCH(QString, model);
    QFETCH(std::vector<Rgb>, parameters);
    const models::Model& fitted = models::findModel(model.toStdString());
    const FitResult result = fit(*bake(fitted, test::leadingParameters(fitted, parameters)), fitted);
    verifyInsideHardRanges(result);
    QVERIFY2(result.errors[0] < 1e-5, qPrintable(QString::number(result.errors[0])));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const models::ParameterSpec& spec = fitted.spec().parameters[i];
      if (spec.group == models::ParameterGroup::shadowing) continue;
      for (int c = 0; c < 3; ++c) {
        const double found = result.parameters.values[i][c], known = parameters[i][c];
        QVERIFY2(std::abs(found - known) <= 0.01 * std::abs(known) + 1e-6,
                 qPrintable(QString("%1: %2, not %3").arg(spec.id.data()).arg(found).arg(known)));
      }
    }
  }

  void everyMetricRecovers() {
    const models::Model& ggx = models::findModel("ggx");
    const models::ParameterValues known = ggxValues({body, tint, Rgb(0.15), Rgb(0.2), Rgb(0)});
    const auto table = bake(ggx, known);
    for (const metrics::BrdfMetric metric : metrics::minimisableMetrics()) {
      const FitResult result = fit(*table, ggx, {.metric = metric});
      for (std::size_t i = 0; i < known.values.size(); ++i)
        for (int c = 0; c < 3; ++c)
          QVERIFY2(std::abs(result.parameters.values[i][c] - known.values[i][c]) <= 0.01 * known.values[i][c] + 1e-6,
                   metrics::metricId(metric).data());
    }
  }

  /// No point of the parameter space that is tried at random, with its best linear parameters, fits better.
  void neverWorseThanAnyStart() {
    const auto table = likeMeasured();
    const models::Model& ggx = models::findModel("ggx");
    const FitResult result = fit(*table, ggx);
    verifyInsideHardRanges(result);
    const FitTarget all(stratifiedCells(*table, selectCells(*table, metrics::defaultMaxPolarAngle), 1000, 1000),
                        MetricTransform(metrics::BrdfMetric::log));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> unit(0, 1);
    const models::ParameterValues start = models::defaultParameters(ggx.spec());
    for (int trial = 0; trial < 60; ++trial) {
      ProjectedProblem problem(ggx, all, start, {2, 3}, {0, 1, 2});
      std::vector<double> units = problem.unitsOf(start);
      if (trial > 0) units = {unit(random), unit(random)};
      problem.cost(units);
      const double error = metrics::brdfErrors(*table, *ggx.instantiate(problem.bestParameters()))[0];
      QVERIFY2(result.errors[0] <= error * 1.002, qPrintable(QString("%1 %2").arg(result.errors[0]).arg(error)));
    }
  }

  void hardCase12BlackChannel() {
    for (const char* name : {"ggx", "sgd"}) {
      const models::Model& model = models::findModel(name);
      models::ParameterValues known = models::defaultParameters(model.spec());
      known.values[0] = Rgb(0.1, 0, 0.2);
      known.values[1] = Rgb(1, 0, 0.5);
      const FitResult result = fit(*bake(model, known), model);
      for (int i = 0; i < 2; ++i) {
        QCOMPARE(result.parameters.values[i].y, 0.0);
        QVERIFY(std::abs(result.parameters.values[i].x / known.values[i].x - 1) < 0.01);
      }
      QVERIFY(result.errors[0] < 1e-5);
    }
  }

  void hardCase12AllBlackTable() {
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(*constantTable(Rgb(0)), *model);
      const models::ParameterValues defaults = models::defaultParameters(model->spec());
      for (std::size_t i = 0; i < defaults.values.size(); ++i) {
        const bool linear = model->spec().parameters[i].linear;
        if (std::ranges::count(optionalLobes(model->spec()), i)) continue;  // none of them is worth having
        QVERIFY(result.parameters.values[i] == (linear ? Rgb(0) : defaults.values[i]));
      }
      QCOMPARE(result.errors[0], 0.0);
    }
  }

  /// A constant table is Lambert's: no model invents a highlight, and what the data do not determine stays put.
  void hardCase14ConstantTable() {
    const auto table = constantTable(Rgb(0.1, 0.2, 0.05));
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(*table, *model);
      verifyInsideHardRanges(result);
      const double bound = std::max(1e-6, model->spec().constantError);
      QVERIFY2(result.errors[0] < bound,
               qPrintable(QString("%1: error %2, expected less than %3. A model that cannot reproduce a constant "
                                  "states its ModelSpec::constantError.")
                              .arg(model->spec().id.data())
                              .arg(result.errors[0])
                              .arg(bound)));
    }
    const FitResult ggx = fit(*table, models::findModel("ggx"));
    QVERIFY(std::abs(ggx.parameters.values[0].y / (pi * 0.2) - 1) < 1e-3);
  }

  void tableWithoutData() {
    const auto table = std::make_shared<const TabulatedBrdf>(
        smallGrid, std::vector<TabulatedBrdf::Value>(smallGrid.size()), std::vector<std::uint8_t>(smallGrid.size(), 0));
    const FitResult result = fit(*table, models::findModel("ggx"));
    QCOMPARE(result.usedCells, std::size_t(0));
    QCOMPARE(result.invalidCells, smallGrid.size());
    verifyInsideHardRanges(result);
    QVERIFY(result.parameters.values[0] == Rgb(0));
  }

  void hardCase50SameBitsForAnyThreadCount() {
    const auto table = likeMeasured();
    for (const char* name : {"ggx", "sgd"}) {
      const models::Model& model = models::findModel(name);
      const FitResult two = fit(*table, model);
      const ThreadLimit limit(1);
      const FitResult one = fit(*table, model);
      QVERIFY(one.parameters == two.parameters);
      QVERIFY(one.errors == two.errors);
    }
  }

  void progressNeverFalls() {
    double last = 0;
    bool falls = false;
    const TaskControl control{{}, [&](double fraction) {
                                falls = falls || fraction < last || fraction > 1;
                                last = fraction;
                              }};
    fit(*likeMeasured(), models::findModel("sgd"), {}, control);
    QVERIFY(!falls);
    QCOMPARE(last, 1.0);
  }

  /// Stopped at once or on the way: never an exception, the parameters of a fit as far as it came.
  void cancelledReturnsTheBestSoFar() {
    const auto table = likeMeasured();
    const models::Model& ggx = models::findModel("ggx");
    double lastError = 0;
    for (const double stopAt : {0.0, 0.2, 0.5, 2.0}) {
      std::stop_source source;
      if (stopAt == 0) source.request_stop();
      const TaskControl control{source.get_token(), [&](double fraction) {
                                  if (fraction > stopAt) source.request_stop();
                                }};
      const FitResult result = fit(*table, ggx, {}, control);
      QCOMPARE(result.cancelled, stopAt < 1);
      verifyInsideHardRanges(result);
      QVERIFY(result.errors[0] > 0);
      if (stopAt > 0) QVERIFY(result.errors[0] <= lastError * 1.01);
      lastError = result.errors[0];
    }
  }
};

GONIO_TEST(FitTest)
}  // namespace fit_test

#include "fit_test.moc"
