// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include <QTest>
#include <cmath>
#include <random>

#include "core/fitting/fit_data.h"
#include "core/fitting/fit_parameters.h"
#include "core/fitting/group_fit.h"
#include "tests/support/test_program.h"

namespace degenerate_measurements_test {
using namespace gonio;
using namespace gonio::fitting;

// Every cell is among those that a fit looks at: what holds for them holds for the table.
constexpr HalfDifferenceGrid grid{.thetaHCount = 12, .thetaDCount = 8, .phiDCount = 5};
using Values = std::vector<TabulatedBrdf::Value>;

template <typename ValueAt>
TabulatedBrdf tableOf(ValueAt valueAt, bool isMeasured = true) {
  Values values(grid.size());
  std::vector<std::uint8_t> valid(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    values[i] = valueAt(i);
    valid[i] = isMeasured && grid.nodeAboveHorizon(i);
  }
  return {grid, std::move(values), std::move(valid)};
}

/// Of any length and shape, over nine decades, with black cells.
TabulatedBrdf randomTable(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  const float decades = 9 * uniform(random);
  return tableOf([&](std::size_t) {
    const auto value = [&] { return uniform(random) < 0.1f ? 0 : std::pow(10.f, decades * (uniform(random) - 0.5f)); };
    return TabulatedBrdf::Value(value(), value(), value());
  });
}

bool warns(const FitResult& result, const char* text) {
  for (const std::string& warning : result.warnings)
    if (warning.find(text) != std::string::npos) return true;
  return false;
}

/// Defined: finite, inside the hard ranges, and not worse than leaving everything black.
void verifyDefined(const FitResult& result, const TabulatedBrdf& table) {
  models::ParameterValues clamped = result.parameters;
  QVERIFY2(models::clampToHardRange(result.model->spec(), clamped).empty(), result.model->spec().id.data());
  for (const double error : result.errors) QVERIFY2(std::isfinite(error), result.model->spec().id.data());
  const TabulatedBrdf black = tableOf([](std::size_t) { return TabulatedBrdf::Value(0); });
  QVERIFY2(result.errors[0] <= metrics::brdfErrors(table, black)[0] * (1 + 1e-9), result.model->spec().id.data());
}

class DegenerateMeasurementsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void sound() {
    const TabulatedBrdf table = tableOf([](std::size_t i) { return TabulatedBrdf::Value(0.1f + float(i % 7)); });
    QVERIFY(fit(table, models::findModel("ggx")).warnings.empty());
  }

  void hardCase12EmptyChannel() {
    const TabulatedBrdf table = tableOf([](std::size_t i) { return TabulatedBrdf::Value(0.1f + float(i % 7), 0, 1); });
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(table, *model);
      verifyDefined(result, table);
      QVERIFY(warns(result, "green"));
      QVERIFY(!warns(result, "above 0 in red"));
      for (std::size_t i = 0; i < result.parameters.values.size(); ++i)
        if (model->spec().parameters[i].linear) QCOMPARE(result.parameters.values[i].y, 0.0);
    }
  }

  void hardCase14Constant() {
    const TabulatedBrdf table = tableOf([](std::size_t) { return TabulatedBrdf::Value(0.1f, 0.2f, 0.05f); });
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(table, *model);
      verifyDefined(result, table);
      QVERIFY(warns(result, "same value"));
    }
    QVERIFY(warns(fit(table, models::findModel("lambert")), "green, 0.2 1/sr; the fit has the same value."));
  }

  /// The message states the values of the fit, whatever the model made of the constant.
  void hardCase14TheWarningStatesTheFit() {
    const TabulatedBrdf table = tableOf([](std::size_t) { return TabulatedBrdf::Value(0.3f); });
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(table, *model);
      const auto brdf = model->instantiate(result.parameters);
      double least = std::numeric_limits<double>::infinity(), most = 0;
      for (const double theta : {0.0, 0.4, 0.8, 1.2, 1.4})
        for (const double other : {0.0, 0.3, 0.9, 1.3})
          for (const double phi : {0.0, 1.5, 3.1}) {
            const double value = brdf->evaluate(fromSpherical(theta, phi), fromSpherical(other, 0)).x;
            least = std::min(least, value), most = std::max(most, value);
          }
      const bool isConstant = least > 0.2995 && most < 0.3005;
      if (isConstant) QVERIFY2(warns(result, "the fit has the same value."), model->spec().id.data());
      if (most > 0.306 || least < 0.294)
        QVERIFY2(!warns(result, "the fit has the same value."), model->spec().id.data());
      QVERIFY(!warns(result, "diffuse term"));
    }
  }

  /// Constants above the range of the model's parameters: finite, and the parameter at its limit is named.
  void hardCase56BrighterThanTheModel() {
    for (const float value : {50.0f, 3.4e38f}) {
      const TabulatedBrdf table = tableOf([&](std::size_t) { return TabulatedBrdf::Value(value); });
      for (const models::Model* model : models::allModels()) verifyDefined(fit(table, *model), table);
      for (const char* id : {"lambert", "ggx"})
        QVERIFY2(warns(fit(table, models::findModel(id)), "is at its maximum"), id);
    }
  }

  /// One valid cell determines hardly any parameter.
  void hardCase57OneValidCell() {
    Values values(grid.size(), TabulatedBrdf::Value(0.5f));
    std::vector<std::uint8_t> valid(grid.size(), 0);
    valid[grid.index(1, 2, 0)] = 1;
    const TabulatedBrdf table(grid, values, valid);
    for (const models::Model* model : models::allModels())
      QVERIFY2(warns(fit(table, *model), "Only 1 cell is valid"), model->spec().id.data());
  }

  void hardCase15OneSpike() {
    for (const std::size_t spike : {std::size_t(0), grid.index(3, 2, 1)}) {
      const TabulatedBrdf table =
          tableOf([&](std::size_t i) { return TabulatedBrdf::Value(i == spike ? 1e6f : 1e-4f); });
      for (const models::Model* model : models::allModels()) {
        const FitResult result = fit(table, *model);
        verifyDefined(result, table);
        QVERIFY(warns(result, "One cell"));
      }
    }
  }

  void allNegative() {
    const TabulatedBrdf table = tableOf([](std::size_t) { return TabulatedBrdf::Value(-0.5f); });
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(table, *model);
      verifyDefined(result, table);
      QVERIFY(warns(result, "red, green, blue") && warns(result, "below 0"));
      QCOMPARE(result.errors[0], 0.0);
    }
  }

  void noValidCell() {
    const TabulatedBrdf table = tableOf([](std::size_t) { return TabulatedBrdf::Value(1); }, false);
    for (const models::Model* model : models::allModels()) {
      const FitResult result = fit(table, *model);
      verifyDefined(result, table);
      QVERIFY(warns(result, "no valid cell"));
    }
  }

  /// The linear parameters of each start are the best ones too.
  void neverWorseThanTheBestStart() {
    const TabulatedBrdf table = randomTable(5);
    const FitData data(table, {});
    for (const models::Model* model : models::allModels()) {
      const double error = fit(data, *model).errors[0];
      const models::ParameterValues base = models::defaultParameters(model->spec());
      const std::vector<std::size_t> free = parametersOf(model->spec(), base, FitRole::nonlinear);
      double best = std::numeric_limits<double>::infinity();
      for (const models::ParameterValues& start : startingPoints(*model, base, free)) {
        ProjectedProblem problem(*model, data.search(), start, free, {0, 1, 2});
        problem.cost(problem.unitsOf(start));
        const auto brdf = model->instantiate(problem.bestParameters());
        best = std::min(best, metrics::brdfError(metrics::BrdfMetric::log, table, *brdf));
      }
      // Staying near the defaults may cost this much.
      QVERIFY2(error <= best * 1.002,
               qPrintable(QString("%1: %2, %3").arg(model->spec().id.data()).arg(error).arg(best)));
    }
  }

  void randomTables_data() {
    QTest::addColumn<unsigned>("seed");
    for (unsigned seed = 1; seed <= 2; ++seed) QTest::addRow("%u", seed) << seed;
  }
  void randomTables() {
    QFETCH(unsigned, seed);
    const TabulatedBrdf table = randomTable(seed);
    const auto metrics = metrics::minimisableMetrics();
    for (std::size_t m = 0; m < models::allModels().size(); ++m) {
      const models::Model& model = *models::allModels()[m];
      verifyDefined(fit(table, model), table);
      const FitResult result = fit(table, model, {.metric = metrics[(m + seed) % metrics.size()], .gamma = 1.5});
      models::ParameterValues clamped = result.parameters;
      QVERIFY2(models::clampToHardRange(model.spec(), clamped).empty(), model.spec().id.data());
      for (const double error : result.errors) QVERIFY2(std::isfinite(error), model.spec().id.data());
    }
  }
};

GONIO_TEST(DegenerateMeasurementsTest)
}  // namespace degenerate_measurements_test

#include "degenerate_measurements_test.moc"
