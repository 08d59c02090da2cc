// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The Gonio authors
#include "core/fitting/projected_problem.h"

#include <QTest>
#include <cstring>

#include "core/fitting/fit_parameters.h"
#include "core/metrics/brdf_metrics.h"
#include "core/models/registry.h"
#include "tests/support/test_program.h"

namespace projected_problem_test {
using namespace gonio;
using namespace gonio::fitting;

constexpr HalfDifferenceGrid smallGrid{.thetaHCount = 24, .thetaDCount = 20, .phiDCount = 30};

std::shared_ptr<const TabulatedBrdf> tableOf(const char* model, std::initializer_list<Rgb> values) {
  return bakeTable(*models::findModel(model).instantiate({std::vector<Rgb>(values)}), smallGrid);
}

/// A material that no fitted model explains.
std::shared_ptr<const TabulatedBrdf> twoLobes() {
  return tableOf("sgd", {Rgb(0.2, 0.1, 0.05), Rgb(0.3, 0.2, 0.25), Rgb(0.02, 0.03, 0.01), Rgb(0.4), Rgb(0.3), Rgb(0.1),
                         Rgb(3), Rgb(1e-7), Rgb(30), Rgb(0.1)});
}

FitTarget targetOf(const TabulatedBrdf& table, metrics::BrdfMetric metric = metrics::BrdfMetric::log) {
  return FitTarget(stratifiedCells(table, selectCells(table, radians(85)), 8, 8), MetricTransform(metric));
}

std::vector<std::size_t> nonlinearOf(const models::Model& model) {
  return parametersOf(model.spec(), models::defaultParameters(model.spec()), FitRole::nonlinear);
}

class ProjectedProblemTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void unitScaleRoundTrips() {
    for (const models::Model* model : models::allModels())
      for (const models::ParameterSpec& spec : model->spec().parameters) {
        const UnitScale scale(spec);
        QVERIFY(scale.minimum() <= scale.maximum());
        for (const double unit : {0.0, 0.25, 1.0}) {
          const double value = scale.toValue(unit);
          QVERIFY(value >= spec.hardMin && value <= spec.hardMax);
          QVERIFY(std::abs(scale.toUnit(value) - unit) < 1e-9);
        }
        for (const double beyond : {-1e9, 1e9}) {
          const double value = scale.toValue(beyond);
          QVERIFY(value >= spec.hardMin && value <= spec.hardMax);
        }
      }
  }

  /// Half the gradient of the cost is J^T r (Kaufman's Jacobian leaves out only what is orthogonal to the residual):
  /// against differences of the cost itself, with the linear parameters solved anew on each side.
  void gradientIsThatOfTheCost_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<int>("metric");
    QTest::addColumn<bool>("oneChannel");
    for (const metrics::MetricRecord& record : metrics::metricRecords()) {
      // The inner solution of most means of |d|^p is too loose for difference quotients; one stands for them.
      const bool isSmooth = record.minimisable && record.power == metrics::MetricPower::square;
      if (!isSmooth && record.metric != metrics::BrdfMetric::meanAbsoluteLog) continue;
      const int metric = int(record.metric);
      QTest::addRow("ggx %d", metric) << "ggx" << metric << false;
      QTest::addRow("cook-torrance %d", metric) << "cook-torrance" << metric << false;
      QTest::addRow("sgd %d", metric) << "sgd" << metric << true;
      QTest::addRow("sgd together %d", metric) << "sgd" << metric << false;
    }
  }
  void gradientIsThatOfTheCost() {
    QFETCH(QString, model);
    QFETCH(int, metric);
    QFETCH(bool, oneChannel);
    const models::Model& fitted = models::findModel(model.toStdString());
    const auto table = twoLobes();
    const FitTarget target = targetOf(*table, metrics::allBrdfMetrics()[std::size_t(metric)]);
    const std::vector<int> channels = oneChannel ? std::vector<int>{1} : std::vector<int>{0, 1, 2};
    ProjectedProblem problem(fitted, target, models::defaultParameters(fitted.spec()), nonlinearOf(fitted), channels);
    models::ParameterValues start = models::defaultParameters(fitted.spec());
    // Off the kink of SGD's Fresnel term, which is cut at 0.
    if (const auto f0 = fitted.spec().find("f0")) start.values[*f0] = Rgb(0.4);
    std::vector<double> at = problem.unitsOf(start);
    for (std::size_t k = 0; k < at.size(); ++k) at[k] += 0.02 * double(k % 3);
    problem.cost(at);
    Eigen::VectorXd r(problem.residualCount());
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> j(problem.residualCount(),
                                                                             problem.unknownCount());
    problem.residuals(r.data());
    problem.jacobian(j.data());
    const Eigen::VectorXd gradient = 2 * j.transpose() * r;
    QVERIFY(gradient.norm() > 0);
    for (int k = 0; k < problem.unknownCount(); ++k) {
      std::vector<double> low = at, high = at;
      low[k] -= 1e-4;
      high[k] += 1e-4;
      const double difference = (problem.cost(high) - problem.cost(low)) / 2e-4;
      // The inner solution of the mean of absolute values is not as tight.
      const double tolerance = target.metric.isReweighted() ? 0.02 : 1e-3;
      QVERIFY2(std::abs(difference - gradient[k]) <= tolerance * (std::abs(difference) + 0.1 * gradient.norm()),
               qPrintable(QString("unknown %1: %2, %3").arg(k).arg(difference).arg(gradient[k])));
    }
  }

  /// The cost is the metric's own sum.
  void costIsTheMetric() {
    const auto table = twoLobes();
    const models::Model& ggx = models::findModel("ggx");
    for (std::size_t m = 0; m < metrics::minimisableMetrics().size(); ++m) {
      const CellSelection census = selectCells(*table, radians(83.3));
      const FitTarget all(stratifiedCells(*table, census, 1000, 1000), MetricTransform(metrics::allBrdfMetrics()[m]));
      QCOMPARE(all.cells.size(), census.used);
      const models::ParameterValues start = models::defaultParameters(ggx.spec());
      ProjectedProblem problem(ggx, all, start, nonlinearOf(ggx), {0, 1, 2});
      const double cost = problem.cost(problem.unitsOf(start));  // at the defaults the preference costs nothing
      const metrics::MetricRecord& record = metrics::metricRecords()[m];
      const double error =
          metrics::brdfError(record.metric, *table, *ggx.instantiate(problem.bestParameters()), radians(83.3));
      const double expected = record.isRoot ? std::sqrt(cost / 3) : cost / 3;
      // Means of |d|^p are fitted with their tip rounded.
      QVERIFY2(std::abs(error / expected - 1) < (all.metric.isReweighted() ? 0.05 : 1e-6),
               qPrintable(QString("%1 %2").arg(error).arg(expected)));
    }
  }

  void censusCountsEveryCell() {
    const auto table = bakeTable(*models::lambert().instantiate(models::defaultParameters(models::lambert().spec())));
    const CellSelection census = selectCells(*table, radians(85));
    QCOMPARE(census.used, std::size_t(1015451));
    QCOMPARE(census.used + census.grazing, std::size_t(1111432));
    QCOMPARE(census.used + census.grazing + census.invalid, std::size_t(1458000));
    const FitCells cells = stratifiedCells(*table, census, 8, 5);
    double sum = 0;
    for (const double w : cells.rootWeight) sum += w * w;
    QVERIFY(std::abs(sum - 1) < 1e-12);
    QVERIFY(cells.size() > 2000 && cells.size() <= 3600);
  }
};

GONIO_TEST(ProjectedProblemTest)
}  // namespace projected_problem_test

#include "projected_problem_test.moc"
